// SPDX-License-Identifier: MIT
#include "host/papers/turn_first_odometry.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace echomap::papers {
namespace {

using geometry::Pose2;

TEST(TurnFirstOdometry, TurnsThenDrivesAllOfTheIncrementAhead) {
  const Pose2 T_map_now = turned_then_driven({1.0, 2.0, 0.0}, {0.3, 0.4, std::numbers::pi / 2.0});

  EXPECT_NEAR(T_map_now.x_m(), 1.0, 1e-12);
  EXPECT_NEAR(T_map_now.y_m(), 2.5, 1e-12);
  EXPECT_NEAR(T_map_now.heading_rad(), std::numbers::pi / 2.0, 1e-12);
}

TEST(TurnFirstOdometry, DrivesAheadEvenWhereTheIncrementGoesBack) {
  EXPECT_NEAR(turned_then_driven({}, {-0.2, 0.0, 0.0}).x_m(), 0.2, 1e-12);
}

TEST(TurnFirstOdometry, PlacesABeamsEndByPoseAndBearing) {
  const auto point_m =
      scanned_point_m({1.0, 2.0, std::numbers::pi / 2.0}, 3.0, -std::numbers::pi / 2.0);

  EXPECT_LT((point_m - Eigen::Vector2d(4.0, 2.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace echomap::papers
