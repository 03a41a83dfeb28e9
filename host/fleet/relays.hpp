// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "host/fleet/exchange_params.hpp"
#include "host/fleet/fleet_knowledge.hpp"
#include "host/fleet/publications.hpp"

namespace echomap::fleet {

/// Passes on what robots have told that are not here any more: where the broker has lost it, and
/// where somebody asks for it. Of all that have it, the one whose name comes first does so first,
/// the next one after a while, unless it has heard it meanwhile.
class Relays {
 public:
  explicit Relays(const FleetExchangeParams& params);

  /// There is a new connection, and nobody knows what the broker has.
  void on_connected(double now_s) { connected_s_ = now_s; }
  /// Notes a question that is not for this robot itself.
  void note(const HeardAsk& heard, const FleetKnowledge& knowledge, double now_s);
  /// Publishes what nobody else has published in time, and takes back what its author, who is back,
  /// publishes itself.
  void update(const FleetKnowledge& knowledge, Publications& publications, double now_s);

  /// Messages that were passed on.
  std::size_t count() const { return count_; }

 private:
  /// How many living robots come before this one.
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
  /// When each message was asked for, by its author's topic.
  std::map<std::string, double> asked_s_;
  /// Authors of what was passed on, by the topic on which it was.
  std::map<std::string, std::string> authors_;
  std::size_t count_ = 0;
};

}  // namespace echomap::fleet
