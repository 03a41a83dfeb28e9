// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::evaluation {

/// Where the robot truly was at an instant.
struct TruePose {
  time::RobotTime stamp;
  geometry::Pose2 T_world_robot;
};

/// Where the estimated trajectory is off the true one: the absolute trajectory error of Sturm et
/// al. (2012), but without their fitted alignment. Both trajectories are expressed in the robot's
/// frame at the first common instant.
struct TrajectoryError {
  double ate_rmse_m = 0.0;
  double ate_heading_rmse_rad = 0.0;
  double final_error_m = 0.0;
  double final_heading_error_rad = 0.0;
};

/// The true pose at an instant, T_world_robot, linear in time between its neighbours; empty outside
/// of the truth, which is in the order of its stamps, and between neighbours that are farther apart
/// than `max_gap`, where there is one.
std::optional<geometry::Pose2> true_pose_at(
    const std::vector<TruePose>& truth,
    time::RobotTime stamp,
    std::optional<time::RobotClock::duration> max_gap = std::nullopt);

/// Where the map of the estimate lies in the world, by the first pose that the truth knows:
/// T_world_map. Throws std::invalid_argument where it knows none.
geometry::Pose2 start_aligned(const std::vector<pipeline::StampedPose>& estimate,
                              const std::vector<TruePose>& truth);

/// The same by rigid least squares (Umeyama 1991, without scale): the placement that brings the
/// estimated positions nearest to the true ones at the stamps that the truth covers. That of
/// `start_aligned` where the robot has not moved, since positions then fix no heading. Throws
/// std::invalid_argument where the truth covers none.
geometry::Pose2 fit_aligned(const std::vector<pipeline::StampedPose>& estimate,
                            const std::vector<TruePose>& truth);

/// Compares at the stamps of `estimate` that `truth` covers; the truth is interpolated in time.
/// Both in the order of their stamps. Throws std::invalid_argument where they have no instant in
/// common.
TrajectoryError score_trajectory(const std::vector<pipeline::StampedPose>& estimate,
                                 const std::vector<TruePose>& truth);

}  // namespace echomap::evaluation
