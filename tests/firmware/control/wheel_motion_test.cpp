// SPDX-License-Identifier: MIT
#include "firmware/control/wheel_motion.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "firmware/app/settings.hpp"
#include "firmware/boards/native/native_board.hpp"
#include "firmware/control/fixed_point.hpp"
#include "tests/firmware/simulated_wheel.hpp"

namespace echomap::control {
namespace {

using protocol::MotionOutcome;
using tests::quadrature_levels;

class WheelMotionTest : public testing::Test {
 protected:
  ~WheelMotionTest() override { motion_.stop(MotionOutcome::kStopped); }

  void run_ms(int ms) {
    for (int i = 0; i < ms; ++i) {
      const auto& board = native::NativeBoard::instance();
      turn(left_, right_, board.left_duty(), board.right_duty());
      if (++now_ms_ % kControlPeriodMs == 0) {
        motion_.step();
      }
    }
  }
  /// Runs until the motion ends; false where that takes more than `limit_ms`.
  bool run_to_end(int limit_ms) {
    const int until_ms = now_ms_ + limit_ms;
    while (motion_.moving() && now_ms_ < until_ms) {
      run_ms(1);
    }
    return !motion_.moving();
  }
  void move(std::int32_t left, std::int32_t right, std::uint16_t ticks_per_s) {
    motion_.start_move(protocol::MoveTicks{9, left, right, ticks_per_s, 0});
  }

  drivers::WheelEncoders encoders_;
  WheelMotion motion_{encoders_, app::kDefaultDrive};
  tests::SimulatedWheel left_;
  tests::SimulatedWheel right_;

 private:
  void turn(tests::SimulatedWheel& left, tests::SimulatedWheel& right, int duty_l, int duty_r) {
    std::int32_t left_ticks = left.ticks();
    std::int32_t right_ticks = right.ticks();
    left.step(0.001, duty_l);
    right.step(0.001, duty_r);
    while (left_ticks != left.ticks() || right_ticks != right.ticks()) {
      left_ticks += left_ticks < left.ticks() ? 1 : left_ticks > left.ticks() ? -1 : 0;
      right_ticks += right_ticks < right.ticks() ? 1 : right_ticks > right.ticks() ? -1 : 0;
      encoders_.on_pins(static_cast<std::uint8_t>(quadrature_levels(left_ticks) |
                                                  (quadrature_levels(right_ticks) << 2)));
    }
    encoders_.fold();
  }

  int now_ms_ = 0;
};

TEST_F(WheelMotionTest, MovesEndWithinTwoTicksAndRelease) {
  std::mt19937 generator(7);
  for (int i = 0; i < 40; ++i) {
    const std::int32_t left_from = left_.ticks();
    const std::int32_t right_from = right_.ticks();
    const auto left = static_cast<std::int32_t>(generator() % 4001) - 2000;
    const auto right = static_cast<std::int32_t>(generator() % 4001) - 2000;
    move(left, right, static_cast<std::uint16_t>(200 + generator() % 2300));
    ASSERT_TRUE(run_to_end(20000)) << left << ' ' << right;
    EXPECT_EQ(motion_.report().outcome, MotionOutcome::kReached);
    EXPECT_EQ(native::NativeBoard::instance().left_duty(), 0);
    run_ms(300);
    EXPECT_NEAR(left_.ticks() - left_from, left, 3) << right;
    EXPECT_NEAR(right_.ticks() - right_from, right, 3) << left;
  }
}

TEST_F(WheelMotionTest, MovesEndWithoutFrictionToo) {
  left_.dead_zone_duty = 0.0;
  right_.dead_zone_duty = 0.0;
  move(3000, -1000, 1500);
  ASSERT_TRUE(run_to_end(3500));
  EXPECT_EQ(motion_.report().outcome, MotionOutcome::kReached);
  run_ms(300);
  EXPECT_NEAR(left_.ticks(), 3000, 3);
  EXPECT_NEAR(right_.ticks(), -1000, 3);
}

TEST_F(WheelMotionTest, BothWheelsKeepTheirProportionAllTheWay) {
  move(3000, 1000, 2000);
  double worst = 0.0;
  while (motion_.moving()) {
    run_ms(1);
    worst = std::max(worst, std::abs(left_.ticks() / 3.0 - right_.ticks()));
  }
  EXPECT_LE(worst, 30.0);
}

TEST_F(WheelMotionTest, MoveOfNothingIsReachedAtOnce) {
  move(0, 0, 100);
  EXPECT_TRUE(run_to_end(2 * kControlPeriodMs));
  EXPECT_EQ(motion_.report().outcome, MotionOutcome::kReached);
}

TEST_F(WheelMotionTest, StopsWhenAWheelDoesNotFollow) {
  left_.blocked = true;
  move(2000, 2000, 2000);
  ASSERT_TRUE(run_to_end(1500));
  EXPECT_EQ(motion_.report().outcome, MotionOutcome::kStalled);
  EXPECT_EQ(motion_.report().id, 9);
  EXPECT_EQ(native::NativeBoard::instance().right_duty(), 0);
}

TEST_F(WheelMotionTest, ExpiryBrakesTogetherAndDoesNotReachTheEnd) {
  move(20000, 10000, 2500);
  run_ms(1000);
  motion_.expire();
  EXPECT_EQ(motion_.report().outcome, MotionOutcome::kExpired);
  ASSERT_TRUE(run_to_end(1500));
  EXPECT_EQ(motion_.report().outcome, MotionOutcome::kExpired);
  EXPECT_LT(left_.ticks(), 6000);
  EXPECT_NEAR(left_.ticks() / 2.0, right_.ticks(), 20.0) << "it may coast to rest";
}

TEST_F(WheelMotionTest, SetPointsTakeOverAndRampToRest) {
  move(20000, 20000, 2000);
  run_ms(500);
  motion_.drive(500, -500);
  EXPECT_EQ(motion_.report().id, 9);
  EXPECT_EQ(motion_.report().outcome, MotionOutcome::kStopped);
  run_ms(1500);
  EXPECT_NEAR(left_.ticks_per_s(), 500.0, 60.0);
  EXPECT_NEAR(right_.ticks_per_s(), -500.0, 60.0);
  motion_.drive(0, 0);
  EXPECT_TRUE(run_to_end(1500));
  EXPECT_EQ(motion_.report().outcome, MotionOutcome::kStopped);
}

TEST_F(WheelMotionTest, ExpiredSetPointReportsWithoutAnId) {
  motion_.drive(1000, 1000);
  run_ms(500);
  motion_.expire();
  EXPECT_EQ(motion_.report().id, 0);
  EXPECT_EQ(motion_.report().outcome, MotionOutcome::kExpired);
  EXPECT_TRUE(run_to_end(1500));
}

TEST_F(WheelMotionTest, SetPointsAreClippedToTheFastestSpeed) {
  motion_.drive(INT16_MAX, INT16_MIN);
  run_ms(1000);
  EXPECT_NEAR(left_.ticks_per_s(), app::kDefaultDrive.max_ticks_per_s, 100.0);
  EXPECT_NEAR(right_.ticks_per_s(), -app::kDefaultDrive.max_ticks_per_s, 100.0);
}

TEST_F(WheelMotionTest, StopIsAtOnce) {
  move(2000, 2000, 2000);
  run_ms(500);
  motion_.stop(MotionOutcome::kBumped);
  EXPECT_EQ(native::NativeBoard::instance().left_duty(), 0);
  EXPECT_FALSE(motion_.moving());
  EXPECT_EQ(motion_.report().outcome, MotionOutcome::kBumped);
}

TEST_F(WheelMotionTest, KnowsItsCourse) {
  struct Case {
    std::int32_t left, right;
    bool forward, backs_off;
  };
  for (const Case& one : {Case{10, 10, true, false},
                          Case{10, -10, false, false},
                          Case{10, -5, true, false},
                          Case{-10, 0, false, true},
                          Case{-10, -10, false, true}}) {
    move(one.left, one.right, 100);
    EXPECT_EQ(motion_.goes_forward(), one.forward) << one.left << ' ' << one.right;
    EXPECT_EQ(motion_.only_backs_off(), one.backs_off) << one.left << ' ' << one.right;
    motion_.stop(MotionOutcome::kStopped);
  }
}

TEST_F(WheelMotionTest, InvertedMotorAndEncoderCancel) {
  protocol::ConfigureDrive swapped = app::kDefaultDrive;
  swapped.inversions = protocol::kInvertRightMotor | protocol::kInvertRightEncoder;
  motion_.configure(swapped);
  move(500, 500, 1000);
  ASSERT_TRUE(run_to_end(3000));
  EXPECT_NEAR(left_.ticks(), 500, 3);
  EXPECT_NEAR(right_.ticks(), -500, 3);
}

TEST_F(WheelMotionTest, RefusesWhatItCannotDo) {
  const auto accepts_move = [&](std::int32_t left, std::int32_t right, std::uint16_t speed) {
    return motion_.accepts(protocol::MoveTicks{1, left, right, speed, 0});
  };
  EXPECT_TRUE(accepts_move(kMaxMoveTicks, -kMaxMoveTicks, 3000));
  EXPECT_FALSE(accepts_move(kMaxMoveTicks + 1, 0, 3000));
  EXPECT_FALSE(accepts_move(0, -kMaxMoveTicks - 1, 3000));
  EXPECT_FALSE(accepts_move(0, INT32_MIN, 3000));
  EXPECT_FALSE(accepts_move(10, 10, 0));
  EXPECT_FALSE(accepts_move(10, 10, 3001));

  using Settings = protocol::ConfigureDrive;
  const auto accepts = [](std::uint16_t Settings::*field, int value) {
    Settings settings = app::kDefaultDrive;
    settings.*field = static_cast<std::uint16_t>(value);
    return WheelMotion::accepts(settings);
  };
  EXPECT_TRUE(accepts(&Settings::max_ticks_per_s, kMaxTicksPerS));
  EXPECT_FALSE(accepts(&Settings::max_ticks_per_s, kMaxTicksPerS + 1));
  EXPECT_FALSE(accepts(&Settings::max_ticks_per_s, 0));
  EXPECT_FALSE(accepts(&Settings::max_ticks_per_s2, 0));
  for (const auto gain : {&Settings::feed_forward, &Settings::proportional, &Settings::integral}) {
    EXPECT_TRUE(accepts(gain, 32767));
    EXPECT_FALSE(accepts(gain, 32768));
  }
}

}  // namespace
}  // namespace echomap::control
