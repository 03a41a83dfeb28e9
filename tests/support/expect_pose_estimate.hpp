// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/geometry/pose2.hpp"
#include "host/localization/monte_carlo_localizer.hpp"

namespace echomap::tests {

/// Whether the first hypothesis is within so much of the truth.
inline bool is_estimated_near(const localization::PoseBelief& belief,
                              const geometry::Pose2& truth,
                              double within_m,
                              double within_rad) {
  if (belief.hypotheses.empty()) {
    return false;
  }
  const geometry::Pose2& pose = belief.hypotheses.front().T_map_robot;
  const double off_rad = geometry::angle_between(pose.heading_rad(), truth.heading_rad());
  return (pose.position_m() - truth.position_m()).norm() < within_m &&
         std::abs(off_rad) < within_rad;
}

}  // namespace echomap::tests
