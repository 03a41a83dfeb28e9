// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::mapping {

/// Steps of a climb: the first ones, and those at which it ends, in metres; a step turns by so many
/// radians for each metre.
struct PoseClimbSteps {
  double first_m = 0.05;
  double finest_m = 0.01;
  double rad_per_m = 0.5;
};

/// Climbs from a pose to the best one near by, by steps that become ever shorter: to the greatest
/// `value(pose)`. Turns around `pivot_m` of the frame that is placed.
template <class Value>
geometry::Pose2 climbed(const geometry::Pose2& start,
                        const Eigen::Vector2d& pivot_m,
                        const PoseClimbSteps& steps,
                        const Value& value) {
  using geometry::Pose2;
  Pose2 best = start;
  double best_value = value(best);
  for (double step_m = steps.first_m; step_m > steps.finest_m;) {
    bool better = false;
    const auto try_step = [&](const Eigen::Vector3d& step) {
      const double heading_rad = best.heading_rad() + step.z();
      const Eigen::Vector2d at_m = best * pivot_m + step.head<2>();
      const Eigen::Vector2d origin_m = at_m - Pose2(0.0, 0.0, heading_rad) * pivot_m;
      const Pose2 tried(origin_m.x(), origin_m.y(), heading_rad);
      if (const double tried_value = value(tried); tried_value > best_value) {
        best = tried;
        best_value = tried_value;
        better = true;
      }
    };
    for (const Eigen::Vector3d& step : {Eigen::Vector3d(step_m, 0, 0),
                                        Eigen::Vector3d(0, step_m, 0),
                                        Eigen::Vector3d(0, 0, step_m * steps.rad_per_m)}) {
      try_step(step);
      try_step(-step);
    }
    step_m *= better ? 1.0 : 0.5;
  }
  return best;
}

}  // namespace echomap::mapping
