// SPDX-License-Identifier: MIT
#include "host/evaluation/trajectory_error.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/segment.hpp"

namespace echomap::evaluation {

namespace {

using geometry::Pose2;
using pipeline::StampedPose;

/// Mean product of the offsets from the means, below which a robot has not moved: 1 cm each.
constexpr double kMinSpreadM2 = 1e-4;

}  // namespace

std::optional<Pose2> true_pose_at(const std::vector<TruePose>& truth,
                                  time::RobotTime stamp,
                                  std::optional<time::RobotClock::duration> max_gap) {
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
  if (max_gap && after->stamp - before.stamp > *max_gap) {
    return std::nullopt;
  }
  const double share = std::chrono::duration<double>(stamp - before.stamp) /
                       std::chrono::duration<double>(after->stamp - before.stamp);
  const Pose2& from = before.T_world_robot;
  const Pose2& to = after->T_world_robot;
  const Eigen::Vector2d position_m =
      from.position_m() + share * (to.position_m() - from.position_m());
  const double turn_rad = geometry::angle_between(from.heading_rad(), to.heading_rad());
  return Pose2(position_m.x(), position_m.y(), from.heading_rad() + share * turn_rad);
}

geometry::Pose2 start_aligned(const std::vector<StampedPose>& estimate,
                              const std::vector<TruePose>& truth) {
  for (const auto& [stamp, T_map_robot] : estimate) {
    if (const auto T_world_robot = true_pose_at(truth, stamp)) {
      return *T_world_robot * T_map_robot.inverse();
    }
  }
  throw std::invalid_argument("the estimate and the truth have no instant in common");
}

geometry::Pose2 fit_aligned(const std::vector<StampedPose>& estimate,
                            const std::vector<TruePose>& truth) {
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> pairs_m;
  Eigen::Vector2d mean_map_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d mean_world_m = Eigen::Vector2d::Zero();
  for (const auto& [stamp, T_map_robot] : estimate) {
    if (const auto T_world_robot = true_pose_at(truth, stamp)) {
      pairs_m.emplace_back(T_map_robot.position_m(), T_world_robot->position_m());
      mean_map_m += pairs_m.back().first;
      mean_world_m += pairs_m.back().second;
    }
  }
  const double count = std::max(1.0, static_cast<double>(pairs_m.size()));
  mean_map_m /= count;
  mean_world_m /= count;
  double cosine_m2 = 0.0;
  double sine_m2 = 0.0;
  for (const auto& [map_m, world_m] : pairs_m) {
    cosine_m2 += (map_m - mean_map_m).dot(world_m - mean_world_m);
    sine_m2 += geometry::cross(map_m - mean_map_m, world_m - mean_world_m);
  }
  if (std::hypot(cosine_m2, sine_m2) <= kMinSpreadM2 * count) {
    return start_aligned(estimate, truth);
  }
  const Pose2 turn(0.0, 0.0, std::atan2(sine_m2, cosine_m2));
  const Eigen::Vector2d offset_m = mean_world_m - turn * mean_map_m;
  return Pose2(offset_m.x(), offset_m.y(), turn.heading_rad());
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
