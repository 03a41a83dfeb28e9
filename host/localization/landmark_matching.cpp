// SPDX-License-Identifier: MIT
#include "host/localization/landmark_matching.hpp"

namespace echomap::localization {

std::optional<std::size_t> match_landmark(const geometry::Pose2& T_map_robot,
                                          const geometry::Pose2& T_robot_sensor,
                                          const Eigen::Vector2d& point_m,
                                          std::span<const Eigen::Vector2d> landmarks_m,
                                          double max_m) {
  const Eigen::Vector2d seen_m = T_map_robot * (T_robot_sensor * point_m);
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < landmarks_m.size(); ++i) {
    if ((landmarks_m[i] - seen_m).norm() > max_m) {
      continue;
    }
    if (found) {
      return std::nullopt;
    }
    found = i;
  }
  return found;
}

}  // namespace echomap::localization
