// SPDX-License-Identifier: MIT
#include "host/evaluation/trajectory_error.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "host/geometry/angle.hpp"

namespace echomap::evaluation {

namespace {

using geometry::Pose2;
using pipeline::StampedPose;

/// The true pose at an instant, linear between its neighbours; empty outside of the truth.
std::optional<Pose2> true_pose_at(const std::vector<TruePose>& truth, time::RobotTime stamp) {
  const auto is_before = [](const TruePose& pose, time::RobotTime at) { return pose.stamp < at; };
  const auto after = std::lower_bound(truth.begin(), truth.end(), stamp, is_before);
  if (after == truth.end()) {
    return std::nullopt;
  }
  if (after->stamp == stamp) {
    return after->T_world_robot;
  }
  if (after == truth.begin()) {
    return std::nullopt;
  }
  const TruePose& before = *(after - 1);
  const double share = std::chrono::duration<double>(stamp - before.stamp) /
                       std::chrono::duration<double>(after->stamp - before.stamp);
  const Pose2& from = before.T_world_robot;
  const Pose2& to = after->T_world_robot;
  const Eigen::Vector2d position_m =
      from.position_m() + share * (to.position_m() - from.position_m());
  const double turn_rad = geometry::angle_between(from.heading_rad(), to.heading_rad());
  return Pose2(position_m.x(), position_m.y(), from.heading_rad() + share * turn_rad);
}

}  // namespace

geometry::Pose2 start_aligned(const std::vector<StampedPose>& estimate,
                              const std::vector<TruePose>& truth) {
  for (const auto& [stamp, T_map_robot] : estimate) {
    if (const auto T_world_robot = true_pose_at(truth, stamp)) {
      return *T_world_robot * T_map_robot.inverse();
    }
  }
  throw std::invalid_argument("the estimate and the truth have no instant in common");
}

TrajectoryError score_trajectory(const std::vector<StampedPose>& estimate,
                                 const std::vector<TruePose>& truth) {
  const Pose2 T_map_world = start_aligned(estimate, truth).inverse();
  TrajectoryError error;
  double squares_m2 = 0.0;
  double squares_rad2 = 0.0;
  int compared = 0;
  for (const auto& [stamp, T_map_robot] : estimate) {
    const auto T_world_robot = true_pose_at(truth, stamp);
    if (!T_world_robot) {
      continue;
    }
    const Pose2 T_robot_true = T_map_robot.inverse() * T_map_world * *T_world_robot;
    error.final_error_m = T_robot_true.position_m().norm();
    error.final_heading_error_rad = std::abs(T_robot_true.heading_rad());
    squares_m2 += error.final_error_m * error.final_error_m;
    squares_rad2 += error.final_heading_error_rad * error.final_heading_error_rad;
    ++compared;
  }
  error.ate_rmse_m = std::sqrt(squares_m2 / compared);
  error.ate_heading_rmse_rad = std::sqrt(squares_rad2 / compared);
  return error;
}

}  // namespace echomap::evaluation
