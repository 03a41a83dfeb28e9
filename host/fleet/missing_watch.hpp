// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "host/fleet/exchange_params.hpp"
#include "host/fleet/fleet_knowledge.hpp"

namespace echomap::fleet {

/// Finds out what others have made and this robot has not heard, and decides when to ask for it:
/// not at once, as it may be on its way, and less and less often where no answer comes.
class MissingWatch {
 public:
  explicit MissingWatch(const FleetExchangeParams& params);

  /// What to ask for now; of one robot, and of as many objects as one message has room for.
  std::optional<fleet_messages::AskMessage> next(const FleetKnowledge& knowledge, double now_s);

 private:
  struct Watched {
    /// Since when each object has been missing,
    std::map<fleet_messages::ContentHash, double> objects;
    /// and something else: a page of the manifest, a graph, claims, an alignment.
    std::optional<double> rest_since_s;
    std::optional<double> asked_s;
    int asked_in_vain = 0;  ///< How often, since something came.
  };

  void look(const RobotKnowledge& robot, const FleetKnowledge& knowledge, double now_s);
  bool may_ask(const Watched& watched, double now_s) const;
  fleet_messages::AskMessage ask_for(const std::string& robot,
                                     const Watched& watched,
                                     double now_s) const;

  std::string robot_;
  double ask_after_s_;
  double ask_period_s_;
  std::map<std::string, Watched> watched_;
};

}  // namespace echomap::fleet
