// SPDX-License-Identifier: MIT
#include "host/tracking/start_pose.hpp"

#include "host/geometry/angle.hpp"

namespace echomap::tracking {

std::optional<geometry::Pose2> pose_option(const std::vector<double>& numbers) {
  constexpr std::size_t kNumbers = 3;
  if (numbers.size() != kNumbers) {
    return std::nullopt;
  }
  return geometry::Pose2(numbers[0], numbers[1], geometry::radians(numbers[2]));
}

std::optional<StartPose> start_pose(const std::vector<double>& at) {
  const auto T_map_robot = pose_option(at);
  return T_map_robot ? std::optional(StartPose{*T_map_robot}) : std::nullopt;
}

}  // namespace echomap::tracking
