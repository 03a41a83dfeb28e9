// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/placed_reading.hpp"

namespace echomap::exploration {

/// One reading as seen from the robot's middle.
struct ViewedRange {
  double bearing_rad = 0.0;  ///< From the way to the goal, counter-clockwise.
  double range_m = 0.0;      ///< The farthest there is where nothing answered.
};

/// Where a view is torn: of two neighbours one is much nearer.
struct Discontinuity {
  ViewedRange near;    ///< The nearer of the two.
  int free_side = 0;   ///< 1 where the farther one lies counter-clockwise of it, else -1.
  double width_m = 0;  ///< Of the opening that begins here, across; infinite where it has one end.
};

/// What of a scan lies within `half_view_rad` of the way to the goal, from right to left: the
/// "correct orientation view" of Hennessey et al., section II.A, with half of a view of 180
/// degrees. The goal and the robot are where the scan places them.
std::vector<ViewedRange> front_view(const mapping::Scan& scan,
                                    const geometry::Pose2& T_map_robot,
                                    double goal_bearing_map_rad,
                                    double half_view_rad,
                                    double max_m);

/// Every pair of neighbours in a view whose ranges differ by more than `jump_m`, from right to left
/// (Kamon, Rimon and Rivlin 1998: the ends of the blocking obstacles).
std::vector<Discontinuity> discontinuities(const std::vector<ViewedRange>& view, double jump_m);

}  // namespace echomap::exploration
