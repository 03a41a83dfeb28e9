// SPDX-License-Identifier: MIT
#include "host/models/landmark_view.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::models {
namespace {

using geometry::Pose2;

TEST(LandmarkView, OfASensorThatSitsAheadAndLooksLeft) {
  const Pose2 T_robot_sensor(0.5, 0.0, geometry::radians(90.0));
  const auto view = landmark_view({1.0, 2.0, geometry::radians(90.0)}, T_robot_sensor, {1.0, 4.5});
  ASSERT_TRUE(view);
  EXPECT_NEAR(view->range_m, 2.0, 1e-12);
  EXPECT_NEAR(view->bearing_rad, geometry::radians(-90.0), 1e-12);
}

TEST(LandmarkView, JacobianIsTheNumericOne) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> spread(-3.0, 3.0);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d pose(spread(random), spread(random), spread(random));
    const Pose2 T_robot_sensor(0.1 * spread(random), 0.1 * spread(random), spread(random));
    const Eigen::Vector2d landmark_m(spread(random), 8.0 + spread(random));
    const auto at = [&](const Eigen::Vector3d& x) {
      return *landmark_view({x(0), x(1), x(2)}, T_robot_sensor, landmark_m);
    };
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d off = kStep * Eigen::Vector3d::Unit(k);
      const LandmarkView more = at(pose + off);
      const LandmarkView less = at(pose - off);
      const double turn_rad = geometry::angle_between(less.bearing_rad, more.bearing_rad);
      EXPECT_NEAR(
          at(pose).jacobian_pose(0, k), (more.range_m - less.range_m) / (2.0 * kStep), 1e-6);
      EXPECT_NEAR(at(pose).jacobian_pose(1, k), turn_rad / (2.0 * kStep), 1e-6);
    }
  }
}

TEST(LandmarkView, OfALandmarkUnderTheSensorIsNone) {
  EXPECT_FALSE(landmark_view({1.0, 2.0, 0.0}, {0.5, 0.0, 0.0}, {1.5, 2.0}));
}

}  // namespace
}  // namespace echomap::models
