// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "host/exploration/explorer.hpp"
#include "host/team_exploration/team_board.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::tests {

/// A tenth of a second straight ahead.
inline constexpr exploration::Roll kRollAhead{0.25, 0.0, 0.1};

/// A board in memory that shows a view and keeps what was claimed.
class ToldBoard final : public team_exploration::TeamBoard {
 public:
  team_exploration::TeamView view() override { return shown; }
  void claim(const std::optional<team_exploration::Claim>& claim) override {
    claims.push_back(claim);
  }

  team_exploration::TeamView shown;
  std::vector<std::optional<team_exploration::Claim>> claims;
};

inline team_exploration::Peer peer_at(const std::string& robot,
                                      const geometry::Pose2& T_map_robot) {
  return {robot, T_map_robot, 0.0, 0.09, 0.1, 0.0};
}

/// Free floor of 6 m x 2 m with its walls, around the start, but for the wall at the far end of x.
inline mapping::OccupancyGrid open_hall(bool closed = false) {
  mapping::OccupancyGrid grid;
  for (int y = -20; y <= 20; ++y) {
    for (int x = -20; x <= 100; ++x) {
      const bool wall = x == -20 || std::abs(y) == 20 || (closed && x == 100);
      grid.add({x, y}, wall ? 300 : -300);
    }
  }
  return grid;
}

/// A corridor of 0.5 m along x with a niche of 0.5 m to the left, from x = 1 m on.
inline mapping::OccupancyGrid corridor_with_niche() {
  mapping::OccupancyGrid grid;
  for (int y = -20; y <= 20; ++y) {
    for (int x = -20; x <= 80; ++x) {
      const bool corridor = std::abs(y) < 5 && x > -20 && x < 80;
      const bool niche = x > 20 && x < 32 && y >= 5 && y < 16;
      grid.add({x, y}, corridor || niche ? -300 : 300);
    }
  }
  return grid;
}

}  // namespace echomap::tests
