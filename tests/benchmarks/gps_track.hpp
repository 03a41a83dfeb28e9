// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::bench {

struct GpsFix {
  double stamp_s = 0.0;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
};

/// How a path without stamps lies to fixes of known time.
struct GpsAgreement {
  double rmse_m = 0.0;
  double mean_m = 0.0;
  double worst_m = 0.0;
  std::size_t fixes = 0;
};

/// Poses that were kept every `period_s`, but not while the robot stood, against fixes: which pose
/// belongs to a fix is found together with the rigid motion between path and fixes, each in turn
/// for the least squares. A pose's time is its number times the period plus the time that the robot
/// has stood up to then, which only grows. It grows by at most `max_stood_s`, and the path began
/// at most half of that before the first fix.
GpsAgreement agreement_with_gps(std::span<const geometry::Pose2> T_map_robots,
                                std::span<const GpsFix> fixes,
                                double period_s,
                                double max_stood_s);

}  // namespace echomap::bench
