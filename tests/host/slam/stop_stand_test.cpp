// SPDX-License-Identifier: MIT
#include "host/slam/stop_stand.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

using geometry::Pose2;

/// So many readings, each with the body turned to there.
void read_at(double heading_rad, std::size_t count, std::vector<StopReading>& readings) {
  for (std::size_t i = 0; i < count; ++i) {
    readings.push_back({{Pose2(0.0, 0.0, heading_rad)}, {}, 1.0});
  }
}

TEST(StopStand, IsWhatWasReadInOneHeading) {
  std::vector<StopReading> readings;
  read_at(0.0, 10, readings);
  read_at(3.0, 12, readings);
  const auto stands = stands_in(readings, 4, {});
  ASSERT_EQ(stands.size(), 2U);
  EXPECT_EQ(stands[0].stop, 4U);
  EXPECT_EQ(stands[0].last, 10U);
  EXPECT_EQ(stands[1].first, 10U);
  EXPECT_EQ(stands[1].resting, 12U);
  EXPECT_EQ(stands[1].last, 22U);
}

TEST(StopStand, ReadingsWhileTheBodyTurnsBelongToTheOneBefore) {
  std::vector<StopReading> readings;
  read_at(0.0, 10, readings);
  read_at(1.0, 3, readings);
  read_at(2.0, 3, readings);
  read_at(3.0, 12, readings);
  const auto stands = stands_in(readings, 0, {});
  ASSERT_EQ(stands.size(), 2U);
  EXPECT_EQ(stands[0].resting, 10U);
  EXPECT_EQ(stands[0].last, 16U);
  EXPECT_EQ(stands[1].first, 16U);
}

TEST(StopStand, AStopOfFewReadingsHasOne) {
  std::vector<StopReading> readings;
  read_at(0.0, 2, readings);
  ASSERT_EQ(stands_in(readings, 0, {}).size(), 1U);
}

TEST(StopStand, PosesAreNearEachOtherWhereAllOfThemAre) {
  const std::vector<Pose2> poses{{0.0, 0.0, 0.0}, {1.0, 0.0, 3.0}};
  EXPECT_TRUE(are_near(poses, {{0.009, 0.0, 0.0}, {1.0, 0.0, 3.009}}, 0.01, 0.01));
  EXPECT_FALSE(are_near(poses, {{0.0, 0.0, 0.0}, {1.02, 0.0, 3.0}}, 0.01, 0.01));
  EXPECT_FALSE(are_near(poses, {{0.0, 0.0, 0.0}, {1.0, 0.0, 3.02}}, 0.01, 0.01));
  EXPECT_FALSE(are_near(poses, {{0.0, 0.0, 0.0}}, 0.01, 0.01));
}

TEST(StopStand, RefusesInvalidParameters) {
  EXPECT_THROW(validate(StopStandParams{.same_rad = 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(StopStandParams{.min_readings = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
