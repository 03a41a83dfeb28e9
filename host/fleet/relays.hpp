// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "host/fleet/exchange_params.hpp"
#include "host/fleet/fleet_knowledge.hpp"
#include "host/fleet/publications.hpp"

namespace echomap::fleet {

/// Relays the messages of robots that are gone, where the broker has lost them and where another
/// robot requests them. Of all robots that have a message, the one whose name comes first relays it
/// at once; the next one follows after a while, unless it has received it meanwhile.
class Relays {
 public:
  explicit Relays(const FleetExchangeParams& params);

  /// Handles a new connection: it is unknown what the broker has.
  void on_connected(double now_s) { connected_s_ = now_s; }
  /// Records a request for the data of another robot.
  void note(const ReceivedRequest& received, const FleetKnowledge& knowledge, double now_s);
  /// Publishes what no other robot has published in time, and withdraws messages whose author is
  /// back.
  void update(const FleetKnowledge& knowledge, Publications& publications, double now_s);

  /// Number of messages relayed so far.
  std::size_t count() const { return count_; }

 private:
  /// Number of living robots whose names come before this one's.
  int rank(const FleetKnowledge& knowledge, double now_s) const;
  void pass_on(const std::string& author,
               const StoredPayload& stored,
               Publications& publications,
               double now_s);

  std::string fleet_;
  std::string robot_;
  double gone_after_s_;
  double step_s_;
  double connected_s_ = 0.0;
  /// When each message was requested, by its author's topic.
  std::map<std::string, double> requested_s_;
  /// Authors of the relayed messages, by the topic of the relay.
  std::map<std::string, std::string> authors_;
  std::size_t count_ = 0;
};

}  // namespace echomap::fleet
