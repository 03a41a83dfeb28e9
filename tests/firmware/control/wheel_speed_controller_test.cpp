// SPDX-License-Identifier: MIT
#include "firmware/control/wheel_speed_controller.hpp"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "firmware/app/settings.hpp"
#include "firmware/control/fixed_point.hpp"
#include "tests/firmware/simulated_wheel.hpp"

namespace echomap::control {
namespace {

/// A controlled wheel that is asked for speeds; counts what the reference has gone.
class ControlledWheel {
 public:
  WheelSpeedController controller;
  tests::SimulatedWheel wheel;
  /// The motor takes a duty once in so many control periods.
  int periods_of_frame = 1;

  void run_periods(int periods, std::int16_t ticks_per_s) {
    for (int i = 0; i < periods; ++i) {
      const std::int32_t step = per_period(ticks_per_s);
      const auto turned = static_cast<std::int16_t>(wheel.ticks() - last_ticks_);
      last_ticks_ = wheel.ticks();
      controller.prepare(app::kDefaultDrive, step);
      const int duty = controller.update(turned);
      ASSERT_LE(std::abs(duty), 255);
      if (++period_ % periods_of_frame == 0) {
        held_duty_ = duty;
      }
      for (int ms = 0; ms < kControlPeriodMs; ++ms) {
        wheel.step(0.001, held_duty_);
      }
      reference_ += static_cast<double>(step) / kOneTick;
    }
  }
  double lag_ticks() const { return reference_ - wheel.ticks(); }

 private:
  std::int32_t last_ticks_ = 0;
  int period_ = 0;
  int held_duty_ = 0;
  double reference_ = 0.0;
};

/// Periods from a reference that stops to the wheel's arrival.
int periods_until_arrived(ControlledWheel& wheel) {
  int periods = 0;
  while (periods < 1000 && !wheel.controller.arrived()) {
    wheel.run_periods(1, 0);
    ++periods;
  }
  return periods;
}

/// The longest of these times over the phases of the frame of a servo and over several speeds.
int longest_rest_on_a_servo(std::uint8_t arrived_ticks) {
  constexpr int kPeriodsOfFrame = 5;
  int longest = 0;
  for (int phase = 0; phase < kPeriodsOfFrame; ++phase) {
    for (std::int16_t speed = 300; speed <= 2500; speed = static_cast<std::int16_t>(speed + 100)) {
      ControlledWheel wheel;
      wheel.periods_of_frame = kPeriodsOfFrame;
      wheel.controller.arrive_within(arrived_ticks);
      wheel.run_periods(200 + phase, speed);
      longest = std::max(longest, periods_until_arrived(wheel));
    }
  }
  return longest;
}

TEST(WheelSpeedController, ConvergesToTheSpeedAskedFor) {
  for (const int speed : {-2500, -300, 100, 800, 2500}) {
    ControlledWheel wheel;
    wheel.run_periods(500, static_cast<std::int16_t>(speed));
    const std::int32_t from = wheel.wheel.ticks();
    wheel.run_periods(250, static_cast<std::int16_t>(speed));
    EXPECT_NEAR(wheel.wheel.ticks() - from, speed, 3.0 + 0.01 * std::abs(speed));
    EXPECT_FALSE(wheel.controller.stalled(app::kDefaultDrive));
  }
}

TEST(WheelSpeedController, NoTickIsLostWhenTheReferenceStopsAgain) {
  ControlledWheel wheel;
  wheel.run_periods(300, 2000);
  wheel.run_periods(200, -700);
  wheel.run_periods(300, 0);
  EXPECT_TRUE(wheel.controller.arrived());
  EXPECT_LE(std::abs(wheel.lag_ticks()), 3.0);
}

TEST(WheelSpeedController, ServoNeedsMoreRoomNotToHuntRoundItsReference) {
  constexpr int kLongest = 300;
  EXPECT_LE(longest_rest_on_a_servo(WheelSpeedController::kServoArrivedTicks), kLongest);
  EXPECT_GT(longest_rest_on_a_servo(WheelSpeedController::kArrivedTicks), kLongest)
      << "what a servo needs more of is not needed any more";
}

TEST(WheelSpeedController, BlockedWheelStalls) {
  ControlledWheel wheel;
  wheel.wheel.blocked = true;
  wheel.run_periods(50, 2000);
  EXPECT_FALSE(wheel.controller.stalled(app::kDefaultDrive));
  wheel.run_periods(100, 2000);
  EXPECT_TRUE(wheel.controller.stalled(app::kDefaultDrive));
}

TEST(WheelSpeedController, WheelThatDoesNotBreakAwayStalls) {
  ControlledWheel wheel;
  wheel.wheel.blocked = true;
  wheel.run_periods(10, 500);
  wheel.run_periods(200, 0);
  EXPECT_FALSE(wheel.controller.arrived());
  EXPECT_FALSE(wheel.controller.stalled(app::kDefaultDrive));
  wheel.run_periods(100, 0);
  EXPECT_TRUE(wheel.controller.stalled(app::kDefaultDrive));
}

TEST(WheelSpeedController, LargestGainsAndErrorsOnlySaturate) {
  protocol::ConfigureDrive gains = app::kDefaultDrive;
  gains.feed_forward = gains.proportional = gains.integral = protocol::kMaxGain;
  for (const int speed : {32000, -32000}) {
    WheelSpeedController controller;
    const auto against = static_cast<std::int16_t>(speed > 0 ? -128 : 128);
    int duty = 0;
    for (int i = 0; i < 100; ++i) {
      controller.prepare(gains, per_period(static_cast<std::int16_t>(speed)));
      duty = controller.update(against);
    }
    EXPECT_EQ(duty, speed > 0 ? 255 : -255);
  }
}

TEST(WheelSpeedController, ResetForgetsTheLag) {
  ControlledWheel wheel;
  wheel.wheel.blocked = true;
  wheel.run_periods(20, 2000);
  wheel.controller.reset();
  EXPECT_TRUE(wheel.controller.arrived());
  wheel.controller.prepare(app::kDefaultDrive, 0);
  EXPECT_EQ(wheel.controller.update(0), 0);
}

}  // namespace
}  // namespace echomap::control
