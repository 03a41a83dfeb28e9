// SPDX-License-Identifier: MIT
#include "host/geometry/pose2.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::geometry {
namespace {

constexpr double kTiny = 1e-12;

Pose2 random_pose(std::mt19937& random) {
  const auto number = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  return {5.0 * number(), 5.0 * number(), 3.0 * number()};
}

void expect_same(const Pose2& a, const Pose2& b) {
  EXPECT_NEAR((a.position_m() - b.position_m()).norm(), 0.0, kTiny);
  EXPECT_NEAR(angle_between(a.heading_rad(), b.heading_rad()), 0.0, kTiny);
}

TEST(Pose2, PutsAPointOfTheRobotIntoTheWorld) {
  // The robot stands at (2, 1) and looks along +y; a metre ahead of it is (2, 2).
  const Pose2 T_world_robot(2.0, 1.0, radians(90.0));
  const Eigen::Vector2d ahead_m = T_world_robot * Eigen::Vector2d(1.0, 0.0);
  EXPECT_NEAR((ahead_m - Eigen::Vector2d(2.0, 2.0)).norm(), 0.0, kTiny);
}

TEST(Pose2, IsAGroup) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const Pose2 a = random_pose(random);
    const Pose2 b = random_pose(random);
    const Pose2 c = random_pose(random);
    expect_same((a * b) * c, a * (b * c));
    expect_same(a * a.inverse(), Pose2());
    expect_same(a.inverse() * a, Pose2());
    expect_same(Pose2() * a, a);
  }
}

TEST(Pose2, ActsOnPointsAsItsProductsDo) {
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    const Pose2 a = random_pose(random);
    const Pose2 b = random_pose(random);
    const Eigen::Vector2d point_m = random_pose(random).position_m();
    EXPECT_NEAR(((a * b) * point_m - a * (b * point_m)).norm(), 0.0, kTiny);
  }
}

TEST(Pose2, WrapsItsHeading) {
  EXPECT_NEAR(Pose2(0.0, 0.0, radians(270.0)).heading_rad(), radians(-90.0), kTiny);
}

}  // namespace
}  // namespace echomap::geometry
