// SPDX-License-Identifier: MIT
#include "host/team_exploration/claims.hpp"

#include <algorithm>

namespace echomap::team_exploration {

bool beats(const Claim& one, const Claim& other) {
  return one.utility > other.utility || (one.utility == other.utility && one.robot < other.robot);
}

TeamView without_silent(TeamView view, double max_silent_s) {
  std::erase_if(view.peers, [&](const Peer& peer) { return peer.age_s > max_silent_s; });
  std::erase_if(view.claims, [&](const Claim& claim) {
    return std::none_of(view.peers.begin(), view.peers.end(), [&](const Peer& peer) {
      return peer.robot == claim.robot;
    });
  });
  return view;
}

const Claim* claim_of(const TeamView& view, const std::string& robot) {
  const auto found = std::find_if(view.claims.begin(), view.claims.end(), [&](const Claim& claim) {
    return claim.robot == robot;
  });
  return found == view.claims.end() ? nullptr : &*found;
}

std::vector<std::string> deadlock(const TeamView& view,
                                  const std::string& robot,
                                  const std::string& waits_for) {
  std::vector<std::string> chain{robot};
  std::string next = waits_for;
  while (!next.empty() && std::find(chain.begin(), chain.end(), next) == chain.end()) {
    chain.push_back(next);
    const Claim* claim = claim_of(view, next);
    next = claim != nullptr ? claim->waits_for : "";
  }
  return next == robot ? chain : std::vector<std::string>{};
}

}  // namespace echomap::team_exploration
