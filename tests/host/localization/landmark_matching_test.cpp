// SPDX-License-Identifier: MIT
#include "host/localization/landmark_matching.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::localization {
namespace {

const std::vector<Eigen::Vector2d> landmarks_m = {{1.0, 3.0}, {1.0, 5.0}, {1.3, 5.0}};
const geometry::Pose2 T_map_robot(1.0, 1.0, geometry::radians(90.0));
const geometry::Pose2 T_robot_sensor(0.5, 0.0, 0.0);

TEST(LandmarkMatching, FindsTheOneThatIsNear) {
  EXPECT_EQ(match_landmark(T_map_robot, T_robot_sensor, {1.4, 0.1}, landmarks_m, 0.2), 0U);
}

TEST(LandmarkMatching, FindsNoneThatIsTooFar) {
  EXPECT_FALSE(match_landmark(T_map_robot, T_robot_sensor, {1.0, 0.0}, landmarks_m, 0.2));
}

TEST(LandmarkMatching, DoesNotChooseBetweenTwo) {
  EXPECT_FALSE(match_landmark(T_map_robot, T_robot_sensor, {3.5, -0.1}, landmarks_m, 0.25));
  EXPECT_EQ(match_landmark(T_map_robot, T_robot_sensor, {3.5, -0.05}, landmarks_m, 0.1), 1U);
}

}  // namespace
}  // namespace echomap::localization
