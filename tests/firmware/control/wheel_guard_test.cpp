// SPDX-License-Identifier: MIT
#include "firmware/control/wheel_guard.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "firmware/app/settings.hpp"
#include "firmware/boards/edge_counter/edge_counter.hpp"
#include "firmware/boards/native/native_board.hpp"
#include "firmware/control/fixed_point.hpp"
#include "firmware/control/wheel_motion.hpp"
#include "tests/firmware/simulated_wheel.hpp"

namespace echomap::control {
namespace {

using protocol::MotionOutcome;
using tests::quadrature_levels;

constexpr protocol::ConfigureSafety kLimits{0, 0, 100, 50, 2000};

TEST(WheelGuard, SilentWheelStallsAfterItsTime) {
  WheelGuard guard;
  for (int ms = kControlPeriodMs; ms < 100; ms += kControlPeriodMs) {
    EXPECT_EQ(guard.classify(kLimits, {1000, -200, 0, 0}), MotionOutcome::kNone) << ms;
  }
  EXPECT_EQ(guard.classify(kLimits, {1000, -200, 0, 0}), MotionOutcome::kStalled);
}

TEST(WheelGuard, TwoTicksOnwardsOrALowDutyBeginTheTimeAnew) {
  for (const WheelPeriod& break_in : {WheelPeriod{1000, 200, 1, 2}, WheelPeriod{1000, 127, 0, 0}}) {
    WheelGuard guard;
    for (int period = 0; period < 200; ++period) {
      const WheelPeriod now = period % 24 == 23 ? break_in : WheelPeriod{1000, 200, 0, 0};
      EXPECT_EQ(guard.classify(kLimits, now), MotionOutcome::kNone) << period;
    }
  }
}

TEST(WheelGuard, CountsAgainstTheCommandAreARunaway) {
  for (const int direction : {1, -1}) {
    WheelGuard guard;
    const WheelPeriod now{direction * 8000, 0, static_cast<std::int16_t>(-direction * 7), 0};
    for (int ticks = 7; ticks < 50; ticks += 7) {
      EXPECT_EQ(guard.classify(kLimits, now), MotionOutcome::kNone);
    }
    EXPECT_EQ(guard.classify(kLimits, now), MotionOutcome::kRunaway);
  }
}

TEST(WheelGuard, FollowingOrAStandingReferenceForgetsTheRunaway) {
  for (const WheelPeriod& good : {WheelPeriod{8000, 0, 1, 0}, WheelPeriod{0, 0, -7, 0}}) {
    WheelGuard guard;
    for (int period = 0; period < 100; ++period) {
      const WheelPeriod now = period % 7 == 6 ? good : WheelPeriod{8000, 0, -7, 0};
      EXPECT_EQ(guard.classify(kLimits, now), MotionOutcome::kNone) << period;
    }
  }
}

TEST(WheelGuard, TooFastIsTooFastBothWays) {
  for (const int direction : {1, -1}) {
    WheelGuard guard;
    const auto ticks = [direction](int size) {
      return static_cast<std::int16_t>(direction * size);
    };
    EXPECT_EQ(guard.classify(kLimits, {direction * 8000, 0, ticks(7), ticks(31)}),
              MotionOutcome::kNone);
    EXPECT_EQ(guard.classify(kLimits, {direction * 8000, 0, ticks(8), ticks(32)}),
              MotionOutcome::kOverSpeed)
        << "2000 ticks/s";
  }
}

/// All limits, all speeds up to what the encoders can count: 127 edges a millisecond.
TEST(WheelGuard, EveryLimitTripsAtItsSpeed) {
  constexpr int kMaxTicks = 16 * 127;
  for (int limit = 1; limit <= 65'535; limit += limit < 200 || limit > 65'000 ? 1 : 13) {
    const protocol::ConfigureSafety limits{0, 0, 0, 0, static_cast<std::uint16_t>(limit)};
    const int first_ticks = (2 * limit + 124) / 125;
    for (const int ticks : {first_ticks - 1, first_ticks, first_ticks + 525, kMaxTicks}) {
      WheelGuard guard;
      const auto outcome = guard.classify(limits, {0, 0, 0, static_cast<std::int16_t>(ticks)});
      EXPECT_EQ(outcome == MotionOutcome::kOverSpeed, ticks * 62.5 >= limit)
          << limit << " ticks/s, " << ticks << " ticks in 16 ms";
    }
  }
}

TEST(WheelGuard, ZeroSwitchesEachLimitOff) {
  WheelGuard guard;
  for (int period = 0; period < 10000; ++period) {
    EXPECT_EQ(guard.classify({}, {1000, 255, 0, 0}), MotionOutcome::kNone);
    EXPECT_EQ(guard.classify({}, {1000, 255, -500, -2000}), MotionOutcome::kNone);
  }
}

/// A wheel of an everyday robot: its load, friction and speed vary, its encoder chatters by a tick,
/// and something may push it.
class EverydayWheel {
 public:
  explicit EverydayWheel(std::mt19937& generator) : generator_(generator) {
    motor_.time_constant_s = 0.04 + 0.0001 * below(800);
    motor_.no_load_ticks_per_s = 3300 + below(900);
  }

  double pushed_ticks_per_s = 0.0;
  /// Faults.
  bool& blocked = motor_.blocked;
  bool encoder_dead = false;
  int motor_sign = 1;
  double downhill_ticks_per_s = 0.0;

  void step(int duty) {
    load_duty_ += 0.01 * (below(81) - 40) - 0.002 * load_duty_;
    if (below(2000) == 0) {
      motor_.dead_zone_duty = 15.0 + below(35);
    }
    const double loaded = duty == 0 ? 0.0 : duty - std::clamp(load_duty_, -12.0, 12.0);
    motor_.step(0.001, motor_sign * static_cast<int>(std::lround(loaded)));
    if (!blocked) {
      moved_ticks_ += 0.001 * (pushed_ticks_per_s + downhill_ticks_per_s);
    }
  }
  std::int32_t ticks() {
    const std::int32_t chatter = below(50) == 0 ? 1 : 0;
    if (!encoder_dead) {
      seen_ticks_ = motor_.ticks() + static_cast<std::int32_t>(std::floor(moved_ticks_)) + chatter;
    }
    return seen_ticks_;
  }

 private:
  int below(unsigned limit) { return static_cast<int>(generator_() % limit); }

  std::mt19937& generator_;
  tests::SimulatedWheel motor_;
  double load_duty_ = 0.0;
  double moved_ticks_ = 0.0;
  std::int32_t seen_ticks_ = 0;
};

/// Two such wheels under the control of the firmware.
class EverydayRobot {
 public:
  explicit EverydayRobot(std::uint32_t seed) : generator_(seed) { boards::start_edge_count(0); }
  ~EverydayRobot() { motion.stop(MotionOutcome::kStopped); }

  void run_ms(int ms) {
    for (int i = 0; i < ms; ++i, ++now_ms_) {
      turn(left, left_ticks_, native::NativeBoard::instance().left_duty(), 0);
      turn(right, right_ticks_, native::NativeBoard::instance().right_duty(), 2);
      boards::fold_edges();
      if (now_ms_ % kControlPeriodMs == 0) {
        motion.step();
      }
    }
  }
  /// A legal motion of some kind, from its begin to its end.
  void do_something() {
    switch (below(5)) {
      case 0:
        settings.max_ticks_per_s2 = static_cast<std::uint16_t>(1000 + below(9000));
        break;
      case 1:
        push_while_idle();
        break;
      case 2:
        move();
        break;
      default:
        drive();
    }
  }
  /// Milliseconds until the motion ends; -1 where it does not within a second.
  int ms_to_the_end() {
    for (int ms = 1; ms <= 1000; ++ms) {
      run_ms(1);
      if (!motion.moving()) {
        return ms;
      }
    }
    return -1;
  }

  int now_ms() const { return now_ms_; }

  protocol::ConfigureDrive settings = app::kDefaultDrive;
  protocol::ConfigureSafety limits = app::kDefaultSafety;
  drivers::WheelEncoders encoders;
  WheelMotion motion{encoders, settings, limits};

 private:
  std::mt19937 generator_;

 public:
  EverydayWheel left{generator_};
  EverydayWheel right{generator_};

 private:
  int below(unsigned limit) { return static_cast<int>(generator_() % limit); }
  int speed() { return below(6001) - 3000; }

  void turn(EverydayWheel& wheel, std::int32_t& ticks, int duty, unsigned shift) {
    wheel.step(duty);
    const std::int32_t target = wheel.ticks();
    while (ticks != target) {
      ticks += ticks < target ? 1 : -1;
      levels_ =
          (levels_ & ~(3U << shift)) | (static_cast<unsigned>(quadrature_levels(ticks)) << shift);
      boards::count_edges(static_cast<std::uint8_t>(levels_));
    }
  }
  void push_while_idle() {
    left.pushed_ticks_per_s = 2.0 * speed();
    right.pushed_ticks_per_s = 2.0 * speed();
    run_ms(below(1000));
    left.pushed_ticks_per_s = 0.0;
    right.pushed_ticks_per_s = 0.0;
    run_ms(100);
  }
  void move() {
    motion.start_move(
        {1, 2 * speed(), 2 * speed(), static_cast<std::uint16_t>(50 + below(2951)), 0});
    for (int ms = 0; motion.moving() && ms < 3000; ++ms) {
      run_ms(1);
    }
    end();
  }
  void drive() {
    const int setpoints = 1 + below(6);
    for (int i = 0; i < setpoints; ++i) {
      motion.drive(static_cast<std::int16_t>(speed()), static_cast<std::int16_t>(speed()));
      run_ms(1 + below(1500));
    }
    end();
  }
  void end() {
    if (below(2) == 0) {
      motion.expire();
      run_ms(below(300));
    }
    motion.stop(MotionOutcome::kStopped);
    run_ms(below(200));
  }

  std::int32_t left_ticks_ = 0;
  std::int32_t right_ticks_ = 0;
  unsigned levels_ = 0;
  int now_ms_ = 0;
};

bool is_fault(MotionOutcome outcome) {
  return outcome == MotionOutcome::kStalled || outcome == MotionOutcome::kRunaway ||
         outcome == MotionOutcome::kOverSpeed;
}

/// Four hours of it: 24 robots, ten minutes each.
TEST(WheelGuard, HoursOfLegalDrivingRaiseNoAlarm) {
  for (std::uint32_t seed = 1; seed <= 24; ++seed) {
    EverydayRobot robot(seed);
    while (robot.now_ms() < 10 * 60 * 1000) {
      robot.do_something();
      ASSERT_FALSE(is_fault(robot.motion.report().outcome))
          << "seed " << seed << " at " << robot.now_ms()
          << " ms: " << static_cast<int>(robot.motion.report().outcome);
    }
  }
}

struct Fault {
  const char* name;
  void (*plant)(EverydayRobot&);
  MotionOutcome expected;
  int within_ms;  ///< Of its planting.
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class PlantedFault : public testing::TestWithParam<Fault> {};

TEST_P(PlantedFault, IsSeenInTime) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    EverydayRobot robot(seed);
    robot.motion.drive(1500, 1500);
    robot.run_ms(1000);
    ASSERT_TRUE(robot.motion.moving());
    GetParam().plant(robot);
    const int ms = robot.ms_to_the_end();
    EXPECT_EQ(robot.motion.report().outcome, GetParam().expected) << seed;
    EXPECT_NE(ms, -1) << seed;
    EXPECT_LE(ms, GetParam().within_ms) << seed;
    EXPECT_EQ(native::NativeBoard::instance().left_duty(), 0);
    EXPECT_EQ(native::NativeBoard::instance().right_duty(), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Faults,
    PlantedFault,
    testing::Values(Fault{"BlockedWheel",
                          [](EverydayRobot& robot) { robot.left.blocked = true; },
                          MotionOutcome::kStalled,
                          700},
                    Fault{"DeadEncoder",
                          [](EverydayRobot& robot) { robot.right.encoder_dead = true; },
                          MotionOutcome::kStalled,
                          450},
                    Fault{"MotorTheWrongWayRound",
                          [](EverydayRobot& robot) { robot.left.motor_sign = -1; },
                          MotionOutcome::kRunaway,
                          500},
                    Fault{"RobotThatRollsDownhill",
                          [](EverydayRobot& robot) { robot.right.downhill_ticks_per_s = 6000.0; },
                          MotionOutcome::kOverSpeed,
                          100}),
    [](const testing::TestParamInfo<Fault>& one) { return std::string(one.param.name); });

TEST(WheelGuard, SeesAMotorTheWrongWayRoundFromRest) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    EverydayRobot robot(seed);
    robot.right.motor_sign = -1;
    robot.motion.drive(400, 400);
    const int ms = robot.ms_to_the_end();
    EXPECT_EQ(robot.motion.report().outcome, MotionOutcome::kRunaway) << seed;
    EXPECT_LE(ms, 600) << seed;
  }
}

}  // namespace
}  // namespace echomap::control
