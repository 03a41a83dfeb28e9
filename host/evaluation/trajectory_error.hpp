// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::evaluation {

/// Where the estimated trajectory is off the true one: both are expressed in the robot's frame at
/// the first common instant, so nothing is fitted.
struct TrajectoryError {
  double ate_rmse_m = 0.0;
  double ate_heading_rmse_rad = 0.0;
  double final_error_m = 0.0;
  double final_heading_error_rad = 0.0;
};

/// Compares at the stamps of `estimate` that `truth` covers; the truth is interpolated in time.
/// Both in the order of their stamps. Throws std::invalid_argument where they have no instant in
/// common.
TrajectoryError score_trajectory(const std::vector<pipeline::StampedPose>& estimate,
                                 const std::vector<pipeline::StampedPose>& truth);

}  // namespace echomap::evaluation
