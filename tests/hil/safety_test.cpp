// SPDX-License-Identifier: MIT
#include <cstdint>
#include <cstdio>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/hil/on_every_board.hpp"
#include "tests/hil/turning_wheel.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;
using protocol::MotionOutcome;
using runner::Wheel;

constexpr std::uint16_t kTimeToLiveMs = 200;
constexpr std::int16_t kTicksPerS = 1500;
/// From 1500 to 0 ticks/s, where braking takes 128 ms from the default limit of 3000, and one
/// period of tick and control each.
constexpr double kRampMs = 64.0;
constexpr double kPeriodsMs = 5.0;

/// A robot on the move: connected, armed, both motors turning their wheels.
class RobotOnTheMove : public ::testing::Test {
 protected:
  explicit RobotOnTheMove(const char* image) : robot(release_image(image)) {
    robot.each_ms = [this] {
      left.step_ms();
      right.step_ms();
      if (renewing && robot.board().now_ns() / 1'000'000 % 50 == 0) {
        robot.send(protocol::KeepAlive{kTimeToLiveMs});
      }
    };
  }

  void connect_and_arm() {
    ASSERT_TRUE(robot.connect());
    ASSERT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
  }

  void drive() {
    connect_and_arm();
    robot.send(protocol::DriveSetpoint{kTicksPerS, kTicksPerS, kTimeToLiveMs});
    renewing = true;
    robot.run_ms(1000);
    ASSERT_NEAR(left.ticks_per_s(), kTicksPerS, 50);
    ASSERT_NEAR(right.ticks_per_s(), kTicksPerS, 50);
  }

  bool off() {
    const runner::MotorDuty duty = robot.board().motor_duty();
    return duty.left == 0.0 && duty.right == 0.0;
  }

  double now_ms() { return double(robot.board().now_ns()) * 1e-6; }

  /// Milliseconds from now until both PWM outputs are off for good; a
  /// controller that brakes passes through 0 on its way.
  double ms_until_off(std::int64_t watched_ms) {
    const double start_ms = now_ms();
    double last_on_ms = start_ms;
    robot.run_until(
        [&] {
          last_on_ms = off() ? last_on_ms : now_ms();
          return false;
        },
        watched_ms);
    EXPECT_TRUE(off());
    return last_on_ms - start_ms;
  }

  void expect_off_for(std::int64_t ms) {
    for (std::int64_t i = 0; i < ms; ++i) {
      robot.run_ms(1);
      ASSERT_TRUE(off()) << "on again after " << i << " ms";
    }
  }

  MotionOutcome outcome() {
    return static_cast<MotionOutcome>(robot.last<protocol::Status>()->move_outcome);
  }

  RobotSession robot;
  DrivenWheel left{robot.board(), Wheel::kLeft};
  DrivenWheel right{robot.board(), Wheel::kRight};
  bool renewing = false;
};

class MovingRobot : public RobotOnTheMove, public ::testing::WithParamInterface<const char*> {
 protected:
  MovingRobot() : RobotOnTheMove(GetParam()) {}
};

INSTANTIATE_TEST_SUITE_P(Boards, MovingRobot, every_board(), image_label);

TEST_P(MovingRobot, StopsWithinTimeToLiveAndRampOnceTheHostIsSilent) {
  drive();
  renewing = false;
  robot.send(protocol::KeepAlive{kTimeToLiveMs});
  robot.run_ms(1);  // the frame's eight bytes at 115200 baud
  const double ms = ms_until_off(1500);
  RecordProperty("off_after_keep_alive_ms", std::to_string(ms));
  std::printf("time to live %d ms: PWM off %.2f ms after the last KeepAlive\n", kTimeToLiveMs, ms);
  EXPECT_GT(ms, kTimeToLiveMs - 2.0);
  EXPECT_LE(ms, kTimeToLiveMs + kRampMs + kPeriodsMs);
  EXPECT_EQ(outcome(), MotionOutcome::kExpired);
}

TEST_P(MovingRobot, MoveExpiresToo) {
  connect_and_arm();
  ASSERT_EQ(robot.command(protocol::MoveTicks{0, 20000, 20000, 1500, kTimeToLiveMs}),
            CommandStatus::kAccepted);
  const double ms = ms_until_off(2000);
  std::printf("time to live %d ms: move without KeepAlive off after %.2f ms\n", kTimeToLiveMs, ms);
  EXPECT_LE(ms, kTimeToLiveMs + kRampMs + kPeriodsMs);
  EXPECT_EQ(outcome(), MotionOutcome::kExpired);
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
  EXPECT_EQ(outcome(), MotionOutcome::kReached);
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
class BumpedRobot : public RobotOnTheMove, public ::testing::WithParamInterface<Bump> {
 protected:
  BumpedRobot() : RobotOnTheMove(std::get<0>(GetParam())) {}
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
  EXPECT_EQ(outcome(), MotionOutcome::kBumped);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, 500, 500, 800, 200}), CommandStatus::kBlocked);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, -500, -500, 800, 200}), CommandStatus::kAccepted);
}

class HungRobot : public MovingRobot {
 protected:
  /// After a hang: PWM off by the watchdog's interrupt, then a reset that disarms.
  void expect_watchdog_reset() {
    renewing = false;
    robot.forget_heard();
    const double start_ms = now_ms();
    ASSERT_TRUE(robot.run_until([this] { return off(); }, 400));
    const double off_ms = now_ms() - start_ms;
    EXPECT_EQ(robot.chip().resets(), 0U) << "PWM goes off before the reset";
    ASSERT_TRUE(robot.run_until([this] { return !off() || robot.chip().resets() != 0; }, 400));
    EXPECT_TRUE(off());
    const double reset_ms = now_ms() - start_ms;
    std::printf("watchdog: PWM off %.1f ms, reset %.1f ms after the hang\n", off_ms, reset_ms);
    RecordProperty("off_after_hang_ms", std::to_string(off_ms));
    EXPECT_LE(off_ms, 150.0);
    EXPECT_LE(reset_ms, 300.0);
    expect_off_for(50);
    ASSERT_TRUE(robot.last<protocol::HelloReply>());
    EXPECT_EQ(robot.last<protocol::HelloReply>()->reset_cause, protocol::kResetWatchdog);
  }

  void expect_disarmed() {
    ASSERT_TRUE(robot.connect(4712));
    EXPECT_EQ(robot.command(protocol::MoveTicks{0, 100, 100, 500, 0}), CommandStatus::kDisarmed);
    robot.send(protocol::DriveSetpoint{kTicksPerS, kTicksPerS, kTimeToLiveMs});
    expect_off_for(100);
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
