// SPDX-License-Identifier: MIT
#include <cstdint>
#include <cstdio>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/hil/measure/robot_on_the_move.hpp"
#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;
using protocol::MotionOutcome;
using runner::Wheel;

/// From 1500 to 0 ticks/s, where braking takes 128 ms from the default limit of 3000, and one
/// period of tick and control each.
constexpr double kRampMs = 64.0;
constexpr double kPeriodsMs = 5.0;

MotionOutcome outcome_of_move(const RobotSession& robot) {
  return static_cast<MotionOutcome>(robot.last<protocol::Status>()->move_outcome);
}

class MovingRobot : protected RobotOnTheMove, public ::testing::TestWithParam<const char*> {
 protected:
  MovingRobot() : RobotOnTheMove(release_image(GetParam())) {}
};

INSTANTIATE_TEST_SUITE_P(Boards, MovingRobot, every_board(), image_label);

TEST_P(MovingRobot, StopsWithinTimeToLiveAndRampOnceTheHostIsSilent) {
  drive();
  renewing = false;
  robot.send(protocol::KeepAlive{kTimeToLiveMs});
  robot.run_ms(1);  // the frame's eight bytes at 115200 baud and faster
  const double ms = ms_until_off(1500);
  RecordProperty("off_after_keep_alive_ms", std::to_string(ms));
  std::printf("time to live %d ms: PWM off %.2f ms after the last KeepAlive\n", kTimeToLiveMs, ms);
  EXPECT_GT(ms, kTimeToLiveMs - 2.0);
  EXPECT_LE(ms, kTimeToLiveMs + kRampMs + kPeriodsMs);
  EXPECT_EQ(outcome_of_move(robot), MotionOutcome::kExpired);
}

TEST_P(MovingRobot, TellsOfItsDutiesWhenItsProgramSetsThem) {
  drive();
  renewing = false;
  std::int64_t off_since_ns = 0;
  robot.board().on_duty = [&] {
    const std::int64_t now_ns = robot.board().now_ns();
    off_since_ns = !off() ? 0 : off_since_ns == 0 ? now_ns : off_since_ns;
  };
  const std::int64_t start_ns = robot.board().now_ns();
  const double ms = ms_until_off(1500);
  EXPECT_NEAR(1e-6 * double(off_since_ns - start_ns), ms, 0.021) << "it looks every 20 us";
}

TEST_P(MovingRobot, MoveExpiresToo) {
  connect_and_arm();
  ASSERT_EQ(robot.command(protocol::MoveTicks{0, 20000, 20000, 1500, kTimeToLiveMs}),
            CommandStatus::kAccepted);
  const double ms = ms_until_off(2000);
  std::printf("time to live %d ms: move without KeepAlive off after %.2f ms\n", kTimeToLiveMs, ms);
  EXPECT_LE(ms, kTimeToLiveMs + kRampMs + kPeriodsMs);
  EXPECT_EQ(outcome_of_move(robot), MotionOutcome::kExpired);
}

TEST_P(MovingRobot, KeepsMovingAsLongAsTheHostRenews) {
  drive();
  for (int i = 0; i < 2000; ++i) {
    robot.run_ms(1);
    ASSERT_FALSE(off());
  }
}

TEST_P(MovingRobot, MoveEndsAtItsCount) {
  connect_and_arm();
  renewing = true;
  ASSERT_EQ(robot.command(protocol::MoveTicks{0, 3000, -1000, 1500, kTimeToLiveMs}),
            CommandStatus::kAccepted);
  robot.run_ms(4000);
  EXPECT_EQ(outcome_of_move(robot), MotionOutcome::kReached);
  std::printf("move of 3000, -1000 ticks ended at %lld, %lld\n",
              static_cast<long long>(left.count()),
              static_cast<long long>(right.count()));
  EXPECT_NEAR(double(left.count()), 3000, 20);
  EXPECT_NEAR(double(right.count()), -1000, 20);
  const auto odometry = robot.last<protocol::Odometry>();
  EXPECT_EQ(odometry->left_ticks, left.count());
  EXPECT_EQ(odometry->right_ticks, right.count());
}

using Bump = std::tuple<const char*, Wheel, std::int64_t>;

/// Bumped on a side, at a time within the tick.
class BumpedRobot : protected RobotOnTheMove, public ::testing::TestWithParam<Bump> {
 protected:
  BumpedRobot() : RobotOnTheMove(release_image(std::get<0>(GetParam()))) {}
};

std::string bump_label(const ::testing::TestParamInfo<Bump>& bump) {
  const auto [image, side, moment_us] = bump.param;
  return label_of(image) + (side == Wheel::kLeft ? "_left_" : "_right_") +
         std::to_string(moment_us) + "us";
}

INSTANTIATE_TEST_SUITE_P(SidesAndMoments,
                         BumpedRobot,
                         ::testing::Combine(every_board(),
                                            ::testing::Values(Wheel::kLeft, Wheel::kRight),
                                            ::testing::Values(0, 170, 390, 610, 880)),
                         bump_label);

TEST_P(BumpedRobot, PwmIsOffWithinTwoMilliseconds) {
  const auto [image, side, moment_us] = GetParam();
  drive();
  robot.board().run_until(robot.board().now_ns() + moment_us * 1000);
  robot.board().set_bump(side, true);
  const double ms = ms_until_off(150);
  std::printf("%s: bump, PWM off after %.3f ms\n", image, ms);
  RecordProperty("off_after_bump_ms", std::to_string(ms));
  EXPECT_LE(ms, 2.0);
  EXPECT_EQ(outcome_of_move(robot), MotionOutcome::kBumped);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, 500, 500, 800, 200}), CommandStatus::kBlocked);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, -500, -500, 800, 200}), CommandStatus::kAccepted);
}

using Edge = std::tuple<const char*, std::int64_t>;

/// Comes to an edge at a time within the tick: a cliff sensor on spare pin 0, a wheel-drop on 1.
class RobotAtAnEdge : protected RobotOnTheMove, public ::testing::TestWithParam<Edge> {
 protected:
  RobotAtAnEdge() : RobotOnTheMove(release_image(std::get<0>(GetParam()))) {
    robot.board().set_aux_level(0, true);
    robot.board().set_aux_level(1, true);
  }
  /// Drives, and shows the hazard on this pin; milliseconds until the PWM is off.
  double ms_from(unsigned pin) {
    connect_and_arm();
    protocol::ConfigurePins pins{};
    pins.pin_0 = protocol::kPinCliffFrontLeft;
    pins.pin_1 = protocol::kPinWheelDrop;
    EXPECT_EQ(robot.command(pins), CommandStatus::kAccepted);
    drive();
    robot.board().run_until(robot.board().now_ns() + std::get<1>(GetParam()) * 1000);
    robot.board().set_aux_level(pin, false);
    return ms_until_off(150);
  }
};

std::string edge_label(const ::testing::TestParamInfo<Edge>& edge) {
  const auto [image, moment_us] = edge.param;
  return label_of(image) + "_" + std::to_string(moment_us) + "us";
}

INSTANTIATE_TEST_SUITE_P(Moments,
                         RobotAtAnEdge,
                         ::testing::Combine(every_board(),
                                            ::testing::Values(0, 170, 390, 610, 880)),
                         edge_label);

TEST_P(RobotAtAnEdge, CliffTakesThePwmOffWithinTwoMilliseconds) {
  const double ms = ms_from(0);
  std::printf("%s: cliff, PWM off after %.3f ms\n", std::get<0>(GetParam()), ms);
  RecordProperty("off_after_cliff_ms", std::to_string(ms));
  EXPECT_LE(ms, 2.0);
  EXPECT_EQ(outcome_of_move(robot), MotionOutcome::kHazard);
  EXPECT_EQ(robot.last<protocol::Status>()->hazards, protocol::kHazardCliffFrontLeft);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, 500, 500, 800, 200}), CommandStatus::kBlocked);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, -500, -500, 800, 200}), CommandStatus::kAccepted);
}

TEST_P(RobotAtAnEdge, WheelDropTakesThePwmOffWithinTwoMillisecondsAndDisarms) {
  const double ms = ms_from(1);
  std::printf("%s: wheel-drop, PWM off after %.3f ms\n", std::get<0>(GetParam()), ms);
  RecordProperty("off_after_wheel_drop_ms", std::to_string(ms));
  EXPECT_LE(ms, 2.0);
  EXPECT_EQ(outcome_of_move(robot), MotionOutcome::kLifted);
  EXPECT_EQ(robot.last<protocol::Status>()->flags & protocol::kFlagArmed, 0);
  EXPECT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kBlocked);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, -500, -500, 800, 200}), CommandStatus::kDisarmed);
}

class HungRobot : public MovingRobot {
 protected:
  /// After a hang: PWM off by the watchdog's interrupt, then a reset that disarms.
  void expect_watchdog_reset() {
    const HangOutcome outcome = outcome_of_hang();
    std::printf("watchdog: PWM off %.1f ms, reset %.1f ms after the hang\n",
                outcome.off_ms,
                outcome.reset_ms);
    RecordProperty("off_after_hang_ms", std::to_string(outcome.off_ms));
    EXPECT_LE(outcome.off_ms, 150.0);
    EXPECT_LE(outcome.reset_ms, 300.0);
    EXPECT_TRUE(outcome.off_before_reset || robot.chip().resets_in_the_warning());
    EXPECT_LE(outcome.off_ms, outcome.reset_ms);
    EXPECT_TRUE(outcome.stayed_off);
    EXPECT_EQ(outcome.reset_cause, protocol::kResetWatchdog);
  }

  void expect_disarmed() {
    ASSERT_TRUE(robot.connect(4712));
    EXPECT_EQ(robot.command(protocol::MoveTicks{0, 100, 100, 500, 0}), CommandStatus::kDisarmed);
    robot.send(protocol::DriveSetpoint{kTicksPerS, kTicksPerS, kTimeToLiveMs});
    EXPECT_TRUE(stays_off_for(100));
    EXPECT_EQ(robot.last<protocol::Odometry>()->flags & protocol::kFlagArmed, 0);
  }
};

INSTANTIATE_TEST_SUITE_P(Boards, HungRobot, every_board(), image_label);

TEST_P(HungRobot, WithoutTicksIsResetAndDisarmed) {
  drive();
  robot.chip().stop_ticks();
  expect_watchdog_reset();
  expect_disarmed();
}

TEST_P(HungRobot, MainLoopThatHangsIsResetAndDisarmed) {
  drive();
  robot.chip().hang();
  expect_watchdog_reset();
  expect_disarmed();
}

}  // namespace
}  // namespace echomap::tests
