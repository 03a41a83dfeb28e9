// SPDX-License-Identifier: MIT
#include "host/exploration/random_bounce.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exploration {
namespace {

using geometry::degrees;

pipeline::Snapshot felt(bool bump, bool virtual_wall, double at_s = 0.0, double x_m = 0.0) {
  pipeline::Snapshot snapshot;
  snapshot.latest = tests::pose_at(at_s, {x_m, 0.0, 0.0});
  snapshot.hazards.bump_right = bump;
  snapshot.hazards.virtual_wall = virtual_wall;
  return snapshot;
}

double turn_deg(RandomBounce& bounce, bool bump, bool virtual_wall) {
  const auto roll = std::get<Roll>(bounce.next(felt(bump, virtual_wall), MotionResult::kReached));
  return roll.forward_m_per_s == 0.0 ? degrees(roll.turn_rad_per_s * roll.for_s) : 0.0;
}

TEST(RandomBounce, GoesStraightUntilABumpOrAVirtualWall) {
  std::mt19937 random(1);
  RandomBounce bounce({}, random);
  EXPECT_EQ(turn_deg(bounce, false, false), 0.0);
  EXPECT_GT(turn_deg(bounce, true, false), 0.0);
  EXPECT_GT(turn_deg(bounce, false, true), 0.0);
  EXPECT_EQ(turn_deg(bounce, false, false), 0.0);
}

TEST(RandomBounce, DrawsItsTurnsFromAllOfTheirRange) {
  std::mt19937 random(1);
  RandomBounce bounce({}, random);
  std::set<double> turns_deg;
  for (int i = 0; i < 200; ++i) {
    turns_deg.insert(turn_deg(bounce, true, false));
  }
  EXPECT_GE(*turns_deg.begin(), 90.0);
  EXPECT_LE(*turns_deg.rbegin(), 270.0);
  EXPECT_LT(*turns_deg.begin(), 100.0);
  EXPECT_GT(*turns_deg.rbegin(), 260.0);
}

TEST(RandomBounce, IsAFunctionOfItsSeed) {
  std::mt19937 first(7);
  std::mt19937 second(7);
  RandomBounce one({}, first);
  RandomBounce other({}, second);
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(turn_deg(one, true, false), turn_deg(other, true, false));
  }
}

TEST(RandomBounce, EndsByTimeOrByWay) {
  std::mt19937 random(1);
  RandomBounce by_time({.max_s = 10.0}, random);
  EXPECT_TRUE(std::holds_alternative<Roll>(by_time.next(felt(false, false, 5.0), {})));
  EXPECT_TRUE(std::holds_alternative<Roll>(by_time.next(felt(false, false, 14.9), {})));
  EXPECT_TRUE(std::holds_alternative<Finished>(by_time.next(felt(false, false, 15.0), {})));
  RandomBounce by_distance({.max_distance_m = 1.0}, random);
  EXPECT_TRUE(std::holds_alternative<Roll>(by_distance.next(felt(false, false, 0.0, 0.0), {})));
  EXPECT_TRUE(std::holds_alternative<Roll>(by_distance.next(felt(false, false, 1.0, 0.6), {})));
  EXPECT_TRUE(std::holds_alternative<Finished>(by_distance.next(felt(false, false, 2.0, 0.1), {})));
}

TEST(RandomBounce, TurnsAwayFromWhatStoppedIt) {
  std::mt19937 random(1);
  RandomBounce bounce({}, random);
  const auto roll = std::get<Roll>(bounce.next(felt(false, false), MotionResult::kHazard));
  EXPECT_EQ(roll.forward_m_per_s, 0.0);
}

TEST(RandomBounce, RefusesParametersWithoutSense) {
  std::mt19937 random(1);
  EXPECT_THROW(RandomBounce({.min_turn_rad = 2.0, .max_turn_rad = 1.0}, random),
               std::invalid_argument);
  EXPECT_THROW(RandomBounce({.max_s = 0.0}, random), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
