// SPDX-License-Identifier: MIT
#include "host/diagnosis/stand_log.hpp"

#include <optional>

#include <gtest/gtest.h>

#include "tests/host/diagnosis/box_log.hpp"

namespace echomap::diagnosis {
namespace {

TEST(StandLog, JoinsStepsOfOneArcAndKeepsThemApartAtStands) {
  BoxLog box({});
  box.stand().drive(0.1).drive(0.1).turn(0.5).turn(0.5).stand().turn(0.5);
  const StandLog& log = box.log();
  ASSERT_EQ(log.stands().size(), 2U);
  EXPECT_EQ(log.stands()[0].steps, 0U);
  EXPECT_EQ(log.stands()[1].steps, 2U);
  ASSERT_EQ(log.steps().size(), 3U);
  EXPECT_NEAR(log.steps()[0].left_m, 0.2, 1e-12);
  EXPECT_NEAR(log.steps()[1].right_m, 0.5 * BoxLog::robot().track_m, 1e-12);
  EXPECT_NEAR(log.travelled_m(), 0.2, 1e-12);
  EXPECT_EQ(log.stops(), 2U);
}

TEST(StandLog, HearsTheWallsAroundAStand) {
  BoxLog box({});
  box.stand().drive(0.1);
  ASSERT_EQ(box.log().stands().size(), 1U);
  const auto& surfaces = box.log().stands().front().surfaces;
  ASSERT_EQ(surfaces.size(), 3U);  // Left, ahead, right.
  EXPECT_GT(surfaces.front().half_length_m, 0.0);
}

TEST(StandLog, BeginsAnotherPieceOfTheWayWhereSomethingHeldTheRobot) {
  BoxLog box({});
  box.stand().drive(0.2);
  box.log().break_way();
  box.drive(0.2).stand();
  ASSERT_EQ(box.log().stands().size(), 2U);
  EXPECT_EQ(box.log().stands()[0].piece, 0U);
  EXPECT_EQ(box.log().stands()[1].piece, 1U);
}

TEST(StandLog, WhatIsHeardBetweenStopsIsNoStandButRollingPings) {
  BoxLog box({});
  box.ping(0.0).drive(0.2).ping(0.1).drive(0.3).stand();
  const StandLog& log = box.log();
  EXPECT_EQ(log.stands().size(), 1U);
  ASSERT_EQ(log.rolling_pings().size(), 2U);
  EXPECT_EQ(log.rolling_pings()[0].rolled.left_m, 0.0);
  EXPECT_NEAR(log.rolling_pings()[0].range_m, 1.9, 1e-12);
  EXPECT_EQ(log.rolling_pings()[1].steps, 0U);
  EXPECT_NEAR(log.rolling_pings()[1].rolled.left_m, 0.2, 1e-12);
  EXPECT_NEAR(log.rolling_pings()[1].bearing_rad, 0.1, 1e-12);
  EXPECT_NEAR(log.rolling_pings()[1].range_m, 1.7, 1e-12);
}

TEST(StandLog, WhatIsHeardInAStopWhileTheBodyTurnsAreRollingPings) {
  BoxLog box({});
  box.stand();
  box.log().begin_stop();
  box.turn(0.4).ping(-0.4).turn(0.2);
  box.log().end_stop();
  EXPECT_EQ(box.log().stands().size(), 1U);
  ASSERT_EQ(box.log().rolling_pings().size(), 1U);
  EXPECT_NEAR(
      box.log().rolling_pings().front().rolled.right_m, 0.2 * BoxLog::robot().track_m, 1e-12);
}

TEST(StandLog, ASilentPingIsNoRollingPing) {
  BoxLog box({});
  box.log().add({{}, {}, 0.0, std::nullopt});
  box.drive(0.2);
  EXPECT_TRUE(box.log().rolling_pings().empty());
}

}  // namespace
}  // namespace echomap::diagnosis
