// SPDX-License-Identifier: MIT
#include "firmware/control/wheel_motion.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "firmware/app/settings.hpp"
#include "firmware/boards/edge_counter/edge_counter.hpp"
#include "firmware/boards/native/native_board.hpp"
#include "firmware/control/fixed_point.hpp"
#include "tests/firmware/simulated_wheel.hpp"

namespace echomap::control {
namespace {

using protocol::MotionOutcome;
using tests::quadrature_levels;

/// From the fastest speed to rest, and one control period.
constexpr int kBrakingMs = 128 + kControlPeriodMs;

class WheelMotionTest : public testing::Test {
 protected:
  WheelMotionTest() { boards::start_edge_count(0); }
  ~WheelMotionTest() override { motion.stop(MotionOutcome::kStopped); }

  void run_ms(int ms) {
    for (int i = 0; i < ms; ++i) {
      turn_wheels();
      if (++now_ms_ % kControlPeriodMs == 0) {
        motion.step();
      }
    }
  }
  /// Runs until the motion ends; false where that takes more than `limit_ms`.
  bool run_to_end(int limit_ms) {
    const int until_ms = now_ms_ + limit_ms;
    while (motion.moving() && now_ms_ < until_ms) {
      run_ms(1);
    }
    return !motion.moving();
  }
  void move(std::int32_t left, std::int32_t right, std::uint16_t ticks_per_s) {
    motion.start_move(protocol::MoveTicks{9, left, right, ticks_per_s, 0});
  }

  drivers::WheelEncoders encoders;
  protocol::ConfigureDrive settings = app::kDefaultDrive;
  protocol::ConfigureSafety limits = app::kDefaultSafety;
  WheelMotion motion{encoders, settings, limits};
  tests::SimulatedWheel left_wheel;
  tests::SimulatedWheel right_wheel;

 private:
  static std::int32_t one_nearer(std::int32_t from, std::int32_t to) {
    if (from == to) {
      return to;
    }
    return from < to ? from + 1 : from - 1;
  }
  void turn_wheels() {
    std::int32_t left_ticks = left_wheel.ticks();
    std::int32_t right_ticks = right_wheel.ticks();
    left_wheel.step(0.001, native::NativeBoard::instance().left_duty());
    right_wheel.step(0.001, native::NativeBoard::instance().right_duty());
    while (left_ticks != left_wheel.ticks() || right_ticks != right_wheel.ticks()) {
      left_ticks = one_nearer(left_ticks, left_wheel.ticks());
      right_ticks = one_nearer(right_ticks, right_wheel.ticks());
      boards::count_edges(static_cast<std::uint8_t>(quadrature_levels(left_ticks) |
                                                    (quadrature_levels(right_ticks) << 2)));
    }
    boards::fold_edges();
  }

  int now_ms_ = 0;
};

TEST_F(WheelMotionTest, MovesEndWithinTwoTicksAndRelease) {
  std::mt19937 generator(7);
  for (int i = 0; i < 40; ++i) {
    const std::int32_t left_from = left_wheel.ticks();
    const std::int32_t right_from = right_wheel.ticks();
    const auto left = static_cast<std::int32_t>(generator() % 4001) - 2000;
    const auto right = static_cast<std::int32_t>(generator() % 4001) - 2000;
    move(left, right, static_cast<std::uint16_t>(200 + generator() % 2300));
    ASSERT_TRUE(run_to_end(20000)) << left << ' ' << right;
    EXPECT_EQ(motion.report().outcome, MotionOutcome::kReached);
    EXPECT_EQ(native::NativeBoard::instance().left_duty(), 0);
    run_ms(300);
    EXPECT_NEAR(left_wheel.ticks() - left_from, left, 3) << right;
    EXPECT_NEAR(right_wheel.ticks() - right_from, right, 3) << left;
  }
}

TEST_F(WheelMotionTest, MovesEndWithoutFrictionToo) {
  left_wheel.dead_zone_duty = 0.0;
  right_wheel.dead_zone_duty = 0.0;
  move(3000, -1000, 1500);
  ASSERT_TRUE(run_to_end(3500));
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kReached);
  run_ms(300);
  EXPECT_NEAR(left_wheel.ticks(), 3000, 3);
  EXPECT_NEAR(right_wheel.ticks(), -1000, 3);
}

TEST_F(WheelMotionTest, BothWheelsKeepTheirProportionAllTheWay) {
  move(3000, 1000, 2000);
  double worst = 0.0;
  while (motion.moving()) {
    run_ms(1);
    worst = std::max(worst, std::abs(left_wheel.ticks() / 3.0 - right_wheel.ticks()));
  }
  EXPECT_LE(worst, 30.0);
}

TEST_F(WheelMotionTest, MoveOfNothingIsReachedAtOnce) {
  move(0, 0, 100);
  EXPECT_TRUE(run_to_end(2 * kControlPeriodMs));
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kReached);
}

TEST_F(WheelMotionTest, StopsWhenAWheelDoesNotFollow) {
  left_wheel.blocked = true;
  move(2000, 2000, 2000);
  ASSERT_TRUE(run_to_end(1500));
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kStalled);
  EXPECT_EQ(motion.report().id, 9);
  EXPECT_EQ(native::NativeBoard::instance().right_duty(), 0);
}

TEST_F(WheelMotionTest, StalledSetPointsWaitForOneOfZeroSpeed) {
  left_wheel.blocked = true;
  motion.drive(1000, 1000);
  ASSERT_TRUE(run_to_end(1500));
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kStalled);
  for (int i = 0; i < 50; ++i) {
    motion.drive(1000, -1000);
    run_ms(20);
    ASSERT_FALSE(motion.moving()) << "no more current into a blocked motor";
  }
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kStalled);
  left_wheel.blocked = false;
  motion.drive(0, 0);
  motion.drive(1000, 1000);
  run_ms(500);
  EXPECT_GT(left_wheel.ticks(), 100);
}

TEST_F(WheelMotionTest, StopLetsStalledSetPointsDriveAgain) {
  left_wheel.blocked = true;
  motion.drive(1000, 1000);
  ASSERT_TRUE(run_to_end(1500));
  motion.stop(MotionOutcome::kStopped);
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kStopped);
  motion.drive(1000, 1000);
  EXPECT_TRUE(motion.moving());
}

TEST_F(WheelMotionTest, StalledMoveLeavesSetPointsAlone) {
  left_wheel.blocked = true;
  move(2000, 2000, 2000);
  ASSERT_TRUE(run_to_end(1500));
  motion.drive(1000, 1000);
  EXPECT_TRUE(motion.moving());
}

TEST_F(WheelMotionTest, ExpiryBrakesTogetherAndDoesNotReachTheEnd) {
  move(20000, 10000, 2500);
  run_ms(1000);
  motion.expire();
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kExpired);
  ASSERT_TRUE(run_to_end(kBrakingMs));
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kExpired);
  EXPECT_LT(left_wheel.ticks(), 6000);
  EXPECT_NEAR(left_wheel.ticks() / 2.0, right_wheel.ticks(), 20.0) << "it may coast to rest";
}

TEST_F(WheelMotionTest, SetPointsTakeOverAndRampToRest) {
  move(20000, 20000, 2000);
  run_ms(500);
  motion.drive(500, -500);
  EXPECT_EQ(motion.report().id, 9);
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kStopped);
  run_ms(1500);
  EXPECT_NEAR(left_wheel.ticks_per_s(), 500.0, 60.0);
  EXPECT_NEAR(right_wheel.ticks_per_s(), -500.0, 60.0);
  motion.drive(0, 0);
  EXPECT_TRUE(run_to_end(1500));
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kStopped);
}

TEST_F(WheelMotionTest, ExpiredSetPointReportsWithoutAnId) {
  motion.drive(1000, 1000);
  run_ms(500);
  motion.expire();
  EXPECT_EQ(motion.report().id, 0);
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kExpired);
  EXPECT_TRUE(run_to_end(kBrakingMs));
}

TEST_F(WheelMotionTest, ExpiryBrakesAsHardHoweverSlowTheRamps) {
  protocol::ConfigureDrive lazy = app::kDefaultDrive;
  lazy.max_ticks_per_s2 = 500;
  motion.configure(lazy);
  move(100000, 100000, lazy.max_ticks_per_s);
  run_ms(7000);
  motion.expire();
  EXPECT_TRUE(run_to_end(kBrakingMs));
}

TEST_F(WheelMotionTest, ExpiryBrakesAsHardHoweverSteepTheRamps) {
  protocol::ConfigureDrive steep = app::kDefaultDrive;
  steep.max_ticks_per_s = 100;
  steep.max_ticks_per_s2 = UINT16_MAX;
  motion.configure(steep);
  move(1000, 1000, 100);
  run_ms(1000);
  EXPECT_LT(left_wheel.ticks_per_s(), 140.0);
  motion.expire();
  EXPECT_TRUE(run_to_end(kBrakingMs));
}

TEST_F(WheelMotionTest, SetPointAfterExpiryKeepsToTheAcceleration) {
  motion.drive(1000, 1000);
  run_ms(500);
  motion.expire();
  run_ms(8);
  motion.drive(3000, 3000);
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kNone);
  run_ms(100);
  EXPECT_LT(left_wheel.ticks_per_s(), 1000.0 + 0.1 * app::kDefaultDrive.max_ticks_per_s2 + 100.0);
  motion.drive(0, 0);
  EXPECT_TRUE(run_to_end(1500));
}

TEST_F(WheelMotionTest, SetPointAfterAnExpiredMoveLeavesItsOutcome) {
  move(20000, 20000, 2000);
  run_ms(500);
  motion.expire();
  motion.drive(500, 500);
  EXPECT_EQ(motion.report().id, 9);
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kExpired);
}

TEST_F(WheelMotionTest, SetPointAfterAStopStartsFromRest) {
  move(-20000, -20000, 3000);
  run_ms(800);
  motion.stop(MotionOutcome::kStopped);
  move(100, 100, 1000);
  motion.drive(1000, 1000);
  run_ms(kControlPeriodMs);
  EXPECT_GE(native::NativeBoard::instance().left_duty(), 0);
}

TEST_F(WheelMotionTest, SetPointsAreClippedToTheFastestSpeed) {
  motion.drive(INT16_MAX, INT16_MIN);
  run_ms(1000);
  EXPECT_NEAR(left_wheel.ticks_per_s(), app::kDefaultDrive.max_ticks_per_s, 100.0);
  EXPECT_NEAR(right_wheel.ticks_per_s(), -app::kDefaultDrive.max_ticks_per_s, 100.0);
}

TEST_F(WheelMotionTest, StopIsAtOnce) {
  move(2000, 2000, 2000);
  run_ms(500);
  motion.stop(MotionOutcome::kBumped);
  EXPECT_EQ(native::NativeBoard::instance().left_duty(), 0);
  EXPECT_FALSE(motion.moving());
  EXPECT_EQ(motion.report().outcome, MotionOutcome::kBumped);
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
    EXPECT_EQ(motion.goes_forward(), one.forward) << one.left << ' ' << one.right;
    EXPECT_EQ(motion.only_backs_off(), one.backs_off) << one.left << ' ' << one.right;
    motion.stop(MotionOutcome::kStopped);
  }
}

TEST_F(WheelMotionTest, InvertedMotorAndEncoderCancel) {
  protocol::ConfigureDrive swapped = app::kDefaultDrive;
  swapped.inversions = protocol::kInvertRightMotor | protocol::kInvertRightEncoder;
  motion.configure(swapped);
  move(500, 500, 1000);
  ASSERT_TRUE(run_to_end(3000));
  EXPECT_NEAR(left_wheel.ticks(), 500, 3);
  EXPECT_NEAR(right_wheel.ticks(), -500, 3);
}

TEST_F(WheelMotionTest, RefusesWhatItCannotDo) {
  const auto accepts_move = [&](std::int32_t left, std::int32_t right, std::uint16_t speed) {
    return motion.accepts(protocol::MoveTicks{1, left, right, speed, 0});
  };
  EXPECT_TRUE(accepts_move(protocol::kMaxMoveTicks, -protocol::kMaxMoveTicks, 3000));
  EXPECT_FALSE(accepts_move(protocol::kMaxMoveTicks + 1, 0, 3000));
  EXPECT_FALSE(accepts_move(0, -protocol::kMaxMoveTicks - 1, 3000));
  EXPECT_FALSE(accepts_move(0, INT32_MIN, 3000));
  EXPECT_FALSE(accepts_move(10, 10, 0));
  EXPECT_FALSE(accepts_move(10, 10, 3001));

  using Settings = protocol::ConfigureDrive;
  const auto accepts = [](std::uint16_t Settings::*field, int value) {
    Settings changed = app::kDefaultDrive;
    changed.*field = static_cast<std::uint16_t>(value);
    return WheelMotion::accepts(changed);
  };
  EXPECT_TRUE(accepts(&Settings::max_ticks_per_s, protocol::kMaxTicksPerS));
  EXPECT_FALSE(accepts(&Settings::max_ticks_per_s, protocol::kMaxTicksPerS + 1));
  EXPECT_FALSE(accepts(&Settings::max_ticks_per_s, 0));
  EXPECT_FALSE(accepts(&Settings::max_ticks_per_s2, 0));
  for (const auto gain : {&Settings::feed_forward, &Settings::proportional, &Settings::integral}) {
    EXPECT_TRUE(accepts(gain, 32767));
    EXPECT_FALSE(accepts(gain, 32768));
  }
}

}  // namespace
}  // namespace echomap::control
