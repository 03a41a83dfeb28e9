// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "host/fleet/exchange_params.hpp"
#include "host/fleet/fleet_knowledge.hpp"

namespace echomap::fleet {

/// Finds out what others have made and this robot has not received, and decides when to request it:
/// not at once, as it may be on its way, and less and less often while no answer comes.
class MissingWatch {
 public:
  explicit MissingWatch(const FleetExchangeParams& params);

  /// The request to send now, for a limited number of objects of one robot; empty for none.
  std::optional<fleet_messages::AskMessage> next(const FleetKnowledge& knowledge, double now_s);

 private:
  struct Watched {
    /// When each object was found missing,
    std::map<fleet_messages::ContentHash, double> objects;
    /// and when anything else was: a page of the manifest, a graph, claims, an alignment.
    std::optional<double> rest_since_s;
    std::optional<double> requested_s;
    int unanswered_requests = 0;  ///< Number of requests since something came.
  };

  void look(const RobotKnowledge& robot, const FleetKnowledge& knowledge, double now_s);
  bool may_request(const Watched& watched, double now_s) const;
  fleet_messages::AskMessage request_for(const std::string& robot,
                                         const Watched& watched,
                                         double now_s) const;

  std::string robot_;
  double request_after_s_;
  double request_period_s_;
  std::map<std::string, Watched> watched_;
};

}  // namespace echomap::fleet
