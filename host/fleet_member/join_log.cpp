// SPDX-License-Identifier: MIT
#include "host/fleet_member/join_log.hpp"

#include <algorithm>

namespace echomap::fleet_member {

void JoinLog::look(double now_s, const std::string& own_map, const team_map::TeamMap& team) {
  const team_map::TeamComponent* component = team.component_of(own_map);
  std::vector<std::string> peers;
  if (component != nullptr) {
    peers = component->robots;
    std::erase(peers, own_map);
  }
  for (LoggedJoin& join : joins_) {
    const bool holds = join.own_map == own_map && std::ranges::count(peers, join.peer_map) > 0;
    if (!join.until_s && holds) {
      std::erase(peers, join.peer_map);
    } else if (!join.until_s) {
      join.until_s = now_s;
    }
  }
  for (const std::string& peer : peers) {
    const auto relative = team.relative_pose(own_map, peer);
    joins_.push_back(
        {own_map, peer, now_s, std::nullopt, relative ? relative->T_own_peer : geometry::Pose2()});
  }
}

}  // namespace echomap::fleet_member
