// SPDX-License-Identifier: MIT
#include "host/time/clock_sync.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::time {
namespace {

using std::chrono::microseconds;

HostTime at_us(std::int64_t instant_us) { return HostTime(microseconds(instant_us)); }

/// A robot that was switched on at `reset_us` of the host's clock, on a line of 2 ms each way.
struct Robot {
  static constexpr std::int64_t kDelayUs = 2000;

  std::int64_t reset_us = 0;
  double rate_error_ppm = 0.0;
  std::uint32_t first_stamp_us = 0;

  std::uint32_t stamp_us(std::int64_t host_us) const {
    const double passed_us =
        static_cast<double>(host_us - reset_us) * (1.0 + rate_error_ppm * 1e-6);
    return first_stamp_us + static_cast<std::uint32_t>(std::llround(passed_us));
  }

  /// Telemetry every 20 ms and a ping every second.
  void talk_to(ClockSync& clock, std::int64_t from_us, std::int64_t to_us) const {
    for (std::int64_t now_us = from_us; now_us < to_us; now_us += 20'000) {
      clock.add_telemetry(stamp_us(now_us), at_us(now_us + kDelayUs));
      if (now_us % 1'000'000 == 0) {
        clock.add_ping(at_us(now_us - kDelayUs), stamp_us(now_us), at_us(now_us + kDelayUs));
      }
    }
  }
};

double error_us(const ClockSync& clock, const Robot& robot, std::int64_t host_us) {
  const auto estimate = clock.host_time(robot.stamp_us(host_us));
  return static_cast<double>((estimate->instant - at_us(host_us)).count());
}

TEST(ClockSync, KnowsNothingBeforeThePing) {
  ClockSync clock;
  clock.add_telemetry(5000, at_us(9000));
  EXPECT_FALSE(clock.host_time(5000));
  EXPECT_FALSE(clock.rate_error_ppm());
  clock.add_ping(at_us(8000), 6000, at_us(10'000));
  EXPECT_TRUE(clock.host_time(5000));
}

TEST(ClockSync, FindsRateAndOffsetOfASteadyLine) {
  for (const double rate_error_ppm : {-5000.0, -50.0, 0.0, 2000.0, 5000.0}) {
    const Robot robot{-7'000'000, rate_error_ppm, 0};
    ClockSync clock;
    robot.talk_to(clock, 0, 20'000'000);
    EXPECT_NEAR(error_us(clock, robot, 20'000'000), 0.0, 5.0) << rate_error_ppm;
    EXPECT_NEAR(*clock.rate_error_ppm(), rate_error_ppm, 0.5);
  }
}

TEST(ClockSync, SaysWhatAnAsymmetryMayCost) {
  const Robot robot;
  ClockSync clock;
  robot.talk_to(clock, 0, 5'000'000);
  EXPECT_NEAR(clock.host_time(0)->asymmetry_us, Robot::kDelayUs, 3.0);
}

TEST(ClockSync, GoesThroughAWrapOfTheRobotsClock) {
  const Robot robot{0, 300.0, 0xFFFF'FFFF - 10'000'000};
  ClockSync clock;
  robot.talk_to(clock, 0, 20'000'000);
  EXPECT_NEAR(error_us(clock, robot, 9'000'000), 0.0, 5.0);
  EXPECT_NEAR(error_us(clock, robot, 20'000'000), 0.0, 5.0);
}

TEST(ClockSync, StartsAnewAfterAReset) {
  ClockSync clock;
  Robot{0, 1000.0, 0}.talk_to(clock, 0, 20'000'000);
  clock.restart();
  EXPECT_FALSE(clock.host_time(0));
  const Robot again{21'000'000, -1000.0, 0};
  again.talk_to(clock, 22'000'000, 30'000'000);
  EXPECT_NEAR(error_us(clock, again, 30'000'000), 0.0, 5.0);
  EXPECT_NEAR(*clock.rate_error_ppm(), -1000.0, 1.0);
}

TEST(ClockSync, FollowsARateThatDrifts) {
  ClockSync clock;
  Robot robot;
  // 20 ppm a minute: two kelvins of a resonator.
  for (std::int64_t from_us = 0; from_us < 300'000'000; from_us += 1'000'000) {
    const std::uint32_t begins_at_us = robot.stamp_us(from_us);
    robot = {from_us, static_cast<double>(from_us) * 20e-6 / 60.0, begins_at_us};
    robot.talk_to(clock, from_us, from_us + 1'000'000);
  }
  EXPECT_NEAR(error_us(clock, robot, 300'000'000), 0.0, 500.0);
}

TEST(ClockSync, BelievesNoTelemetryThatMayKeepTimeWithTheLine) {
  const Robot robot{0, 10.0, 0};
  for (const bool is_random : {false, true}) {
    ClockSync clock({.telemetry_waits_at_random = is_random});
    robot.talk_to(clock, 0, 10'000'000);
    const double before_us = error_us(clock, robot, 10'000'000);
    // Earlier than any pong: the hull of arrivals comes down.
    for (std::int64_t now_us = 10'010'000; now_us < 12'000'000; now_us += 20'000) {
      clock.add_telemetry(robot.stamp_us(now_us), at_us(now_us + Robot::kDelayUs - 500));
    }
    clock.add_ping(at_us(12'000'000 - Robot::kDelayUs),
                   robot.stamp_us(12'000'000),
                   at_us(12'000'000 + Robot::kDelayUs));
    const double change_us = error_us(clock, robot, 12'000'000) - before_us;
    EXPECT_EQ(std::abs(change_us) > 50.0, is_random) << change_us;
  }
}

TEST(ClockSync, NeverClaimsToKnowMoreThanThePhasesTell) {
  const Robot robot;
  for (const double step_us : {0.0, 200.0}) {
    ClockSync clock({.phase_step_us = step_us});
    robot.talk_to(clock, 0, 30'000'000);
    EXPECT_NEAR(*clock.uncertainty_us(), 0.5 * step_us, 10.0);
  }
}

TEST(ClockSync, RefusesParametersThatMakeNoSense) {
  EXPECT_THROW(ClockSync({.window = microseconds(0)}), std::invalid_argument);
  EXPECT_THROW(ClockSync({.fit_period = microseconds(-1)}), std::invalid_argument);
  EXPECT_THROW(ClockSync({.max_rate_error_ppm = 0.0}), std::invalid_argument);
  EXPECT_THROW(ClockSync({.phase_step_us = -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::time
