// SPDX-License-Identifier: MIT
#include "host/evaluation/own_map_pose.hpp"

#include <cmath>

namespace echomap::evaluation {
namespace {

using geometry::Pose2;
using pipeline::StampedPose;

/// Farther away the robot has not mapped what is around a pose.
constexpr double kNearM = 1.5;

}  // namespace

Pose2 own_map_pose(const std::vector<StampedPose>& explored,
                   const std::vector<TruePose>& truth,
                   const Pose2& T_world_pose) {
  Pose2 T_map_world = start_aligned(explored, truth).inverse();
  double nearest_m = kNearM;
  for (const auto& [stamp, T_map_robot] : explored) {
    const auto T_world_robot = true_pose_at(truth, stamp);
    if (!T_world_robot) {
      continue;
    }
    const double away_m = (T_world_robot->position_m() - T_world_pose.position_m()).norm();
    if (away_m < nearest_m) {
      nearest_m = away_m;
      T_map_world = T_map_robot * T_world_robot->inverse();
    }
  }
  return T_map_world * T_world_pose;
}

std::optional<PlaceError> own_map_error(const std::vector<StampedPose>& explored,
                                        const std::vector<TruePose>& truth,
                                        const StampedPose& estimate) {
  const auto T_world_robot = true_pose_at(truth, estimate.stamp);
  if (!T_world_robot) {
    return std::nullopt;
  }
  const Pose2 T_true_told =
      own_map_pose(explored, truth, *T_world_robot).inverse() * estimate.T_map_robot;
  return PlaceError{T_true_told.position_m().norm(), std::abs(T_true_told.heading_rad())};
}

}  // namespace echomap::evaluation
