// SPDX-License-Identifier: MIT
#include "host/mapping/pose_climb.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

using geometry::Pose2;

TEST(PoseClimb, FindsTheTopOfAHillWhateverItTurnsAround) {
  const auto value = [](const Pose2& pose) {
    return -std::abs(pose.x_m() - 0.31) - std::abs(pose.y_m() + 0.12) -
           std::abs(pose.heading_rad() - 0.2);
  };
  const Pose2 top = climbed({}, Eigen::Vector2d::Zero(), {0.05, 0.001, 0.5}, value);
  EXPECT_NEAR(top.x_m(), 0.31, 0.01);
  EXPECT_NEAR(top.y_m(), -0.12, 0.01);
  EXPECT_NEAR(top.heading_rad(), 0.2, 0.01);
}

TEST(PoseClimb, TurnsAroundThePivot) {
  const Eigen::Vector2d pivot_m(2.0, 0.0);
  const auto value = [&](const Pose2& pose) {
    const double off_m = (pose * pivot_m - pivot_m).norm();
    return -std::abs(pose.heading_rad() - 0.3) - 100.0 * off_m;
  };
  const Pose2 turned = climbed({}, pivot_m, {}, value);
  EXPECT_NEAR(turned.heading_rad(), 0.3, 0.03);
  EXPECT_NEAR((turned * pivot_m - pivot_m).norm(), 0.0, 1e-9);
}

}  // namespace
}  // namespace echomap::mapping
