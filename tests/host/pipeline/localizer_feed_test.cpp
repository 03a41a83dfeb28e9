// SPDX-License-Identifier: MIT
#include "host/pipeline/localizer_feed.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace echomap::pipeline {
namespace {

using geometry::Pose2;

TEST(LocalizerFeed, CountsAStepByItsLengthOrItsTurn) {
  const Pose2 before(1.0, 2.0, 3.0);
  EXPECT_FALSE(has_moved(before, before * Pose2(0.09, 0.0, 0.19), 0.1, 0.2));
  EXPECT_TRUE(has_moved(before, before * Pose2(0.0, -0.11, 0.0), 0.1, 0.2));
  EXPECT_TRUE(has_moved(before, before * Pose2(0.0, 0.0, -0.21), 0.1, 0.2));
}

TEST(LocalizerFeed, PicksReadingsEvenlyAndPutsThemBeforeTheRobot) {
  std::vector<localization::RangeReading> gathered;
  for (int i = 0; i < 10; ++i) {
    gathered.push_back({Pose2(1.0, 0.1 * i, 0.0), 0.5 + i});
  }
  const Pose2 T_odom_robot(1.0, -1.0, std::numbers::pi / 2.0);
  const auto picked = evenly_picked(gathered, T_odom_robot, 5);
  ASSERT_EQ(picked.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(picked[i].range_m, 0.5 + 2.0 * static_cast<double>(i));
    EXPECT_NEAR(picked[i].T_robot_sensor.x_m(), 1.0 + 0.2 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(picked[i].T_robot_sensor.y_m(), 0.0, 1e-12);
    EXPECT_NEAR(picked[i].T_robot_sensor.heading_rad(), -std::numbers::pi / 2.0, 1e-12);
  }
}

TEST(LocalizerFeed, PicksTheReadingsNearestToBearings) {
  std::vector<localization::RangeReading> gathered;
  for (int i = 0; i < 60; ++i) {
    gathered.push_back({geometry::Pose2(0.0, 0.0, 1.0 + geometry::radians(6.0 * i)), 0.1 * i});
  }
  const std::vector<double> bearings_rad{geometry::radians(31.0), geometry::radians(-60.0)};
  const auto picked = picked_at_bearings(gathered, {2.0, 0.0, 1.0}, bearings_rad);
  ASSERT_EQ(picked.size(), 2U);
  EXPECT_NEAR(*picked[0].range_m, 0.5, 1e-9) << "at 30 degrees";
  EXPECT_NEAR(*picked[1].range_m, 5.0, 1e-9) << "at 300 degrees";
  EXPECT_TRUE(picked_at_bearings({}, {}, bearings_rad).empty());
  const auto half = std::span(gathered).first(30);
  EXPECT_EQ(picked_at_bearings(half, {2.0, 0.0, 1.0}, bearings_rad).size(), 1U)
      << "nothing was heard at 300 degrees";
}

TEST(LocalizerFeed, TakesAllWhereThereAreFew) {
  const std::vector<localization::RangeReading> gathered(3);
  EXPECT_EQ(evenly_picked(gathered, {}, 60).size(), 3U);
  EXPECT_TRUE(evenly_picked({}, {}, 60).empty());
}

}  // namespace
}  // namespace echomap::pipeline
