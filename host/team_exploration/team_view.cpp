// SPDX-License-Identifier: MIT
#include "host/team_exploration/team_view.hpp"

namespace echomap::team_exploration {

exploration::Company company_of(const TeamView& view) {
  exploration::Company company{view.grid, view.scans, view.features, view.been_m, {}, {}};
  for (const Peer& peer : view.peers) {
    company.standing.push_back(
        {peer.T_map_robot.position_m(), peer.radius_m + peer.position_stddev_m});
  }
  for (const Claim& claim : view.claims) {
    company.promised.push_back({claim.at_m, claim.reach_m, claim.utility});
  }
  return company;
}

}  // namespace echomap::team_exploration
