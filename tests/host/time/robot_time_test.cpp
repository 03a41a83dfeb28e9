// SPDX-License-Identifier: MIT
#include "host/time/robot_time.hpp"

#include <random>
#include <type_traits>

#include <gtest/gtest.h>

#include "host/time/host_time.hpp"
#include "host/time/robot_seconds.hpp"

namespace echomap::time {
namespace {

std::int64_t micros(RobotTime stamp) { return stamp.time_since_epoch().count(); }

TEST(RobotTime, HasNothingToDoWithTheHostsClock) {
  static_assert(!std::is_convertible_v<RobotTime, HostTime>);
  static_assert(!std::is_invocable_v<std::minus<>, RobotTime, HostTime>);
}

TEST(RobotTime, InSecondsIsTheInverse) {
  EXPECT_EQ(robot_seconds(robot_time(0.0)), 0.0);
  EXPECT_DOUBLE_EQ(robot_seconds(robot_time(-12.345678)), -12.345678);
  EXPECT_EQ(micros(robot_time(robot_seconds(RobotTime(RobotClock::duration(1'234'567))))),
            1'234'567);
}

TEST(RobotTimeUnwrapper, FollowsAnyStampsThroughManyWraps) {
  std::mt19937 random(1);
  RobotTimeUnwrapper unwrapper;
  std::int64_t truth_us = 17;
  unwrapper.unwrap(17);
  for (int i = 0; i < 10'000; ++i) {
    truth_us += static_cast<std::int64_t>(random() % 0x7FFFFFFF);
    ASSERT_EQ(micros(unwrapper.unwrap(static_cast<std::uint32_t>(truth_us))), truth_us);
  }
  EXPECT_GT(truth_us, 1'000LL << 32);
}

TEST(RobotTimeUnwrapper, TakesAStampThatIsABitLate) {
  RobotTimeUnwrapper unwrapper;
  unwrapper.unwrap(0xFFFFFF00);
  EXPECT_EQ(micros(unwrapper.unwrap(0x100)), 0x1'0000'0100);
  EXPECT_EQ(micros(unwrapper.unwrap(0xFFFFFFF0)), 0xFFFF'FFF0);
  EXPECT_EQ(micros(unwrapper.unwrap(0x200)), 0x1'0000'0200);
}

TEST(RobotTimeUnwrapper, CountsTheFirstStampFromTheResetHoweverLongAgo) {
  RobotTimeUnwrapper unwrapper;
  EXPECT_EQ(micros(unwrapper.unwrap(0xF000'0000)), 0xF000'0000);
}

TEST(RobotTimeUnwrapper, GoesOnThroughAReset) {
  RobotTimeUnwrapper unwrapper;
  unwrapper.unwrap(0xF000'0000);
  unwrapper.restart();
  EXPECT_EQ(micros(unwrapper.unwrap(0xC000'0000)), 0xF000'0000LL + 0xC000'0000);
  EXPECT_EQ(micros(unwrapper.unwrap(0xC000'0001)), 0xF000'0000LL + 0xC000'0001);
}

TEST(RobotTimeUnwrapper, CountsTheTimeThatPassedWhileTheRobotWasAway) {
  RobotTimeUnwrapper unwrapper;
  unwrapper.unwrap(1'000);
  unwrapper.restart(RobotClock::duration(5'000'000));
  EXPECT_EQ(micros(unwrapper.unwrap(40'000)), 5'001'000);
  EXPECT_EQ(micros(unwrapper.unwrap(60'000)), 5'021'000);
  unwrapper.restart(RobotClock::duration(10'000));
  EXPECT_EQ(micros(unwrapper.unwrap(40'000)), 5'061'000) << "it has been on for longer than that";
}

}  // namespace
}  // namespace echomap::time
