// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/exploration/cost_grid.hpp"
#include "host/exploration/explorer.hpp"
#include "host/exploration/path_follower.hpp"
#include "host/exploration/path_planner.hpp"

namespace echomap::exploration {

/// Leads a robot back to where it started, over floor that the map holds free.
class ReturnPath {
 public:
  ReturnPath(const CostGridParams& costs, const PathFollowerParams& follower)
      : costs_(costs), follower_(follower) {}

  /// The next motion; empty once the robot is there, or where no way is known.
  std::optional<Motion> next(const pipeline::Snapshot& snapshot);

 private:
  CostGridParams costs_;
  PathFollower follower_;
  PathPlanner planner_;
  std::optional<CostGrid> grid_;  ///< Of when the way was planned.
};

}  // namespace echomap::exploration
