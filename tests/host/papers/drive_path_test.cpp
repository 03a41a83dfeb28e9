// SPDX-License-Identifier: MIT
#include "host/papers/drive_path.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace echomap::papers {
namespace {

const std::vector<Eigen::Vector2d> corner_m = {{0.0, 0.0}, {0.1, 0.0}, {0.1, 0.05}};

TEST(DrivePath, GoesFromPointToPointAndTurnsOnTheSpot) {
  const auto poses = drive_path(corner_m, {.length_m = 0.025, .turn_rad = std::numbers::pi / 4.0});
  ASSERT_EQ(poses.size(), 4U + 2U + 2U);
  EXPECT_NEAR((poses[3].position_m() - Eigen::Vector2d(0.075, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(poses[4].position_m(), corner_m[1]);
  EXPECT_NEAR(poses[5].heading_rad(), std::numbers::pi / 4.0, 1e-12);
  EXPECT_NEAR((poses[7].position_m() - Eigen::Vector2d(0.1, 0.025)).norm(), 0.0, 1e-12);
}

TEST(DrivePath, BeginsAPhaseOfAStepBehindTheFirstPoint) {
  const auto poses = drive_path(corner_m, {.length_m = 0.02, .turn_rad = 0.5}, 0.25);
  EXPECT_NEAR(poses.front().x_m(), 0.005, 1e-12);
}

}  // namespace
}  // namespace echomap::papers
