// SPDX-License-Identifier: MIT
#include "hil_mock/world/battery.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echomap::world {
namespace {

NoiseStream battery_noise() { return {1, NoisePurpose::kBattery}; }

TEST(Battery, FallsToEmptyInTheTimeOfItsCapacity) {
  BatteryParams params;
  params.idle_a = 1.0;
  params.resistance_ohm = 0.0;
  Battery battery(params, battery_noise());
  for (int i = 0; i < 3600; ++i) {
    battery.step(1.0, {}, {});
  }
  EXPECT_NEAR(battery.volts(), 7.4, 1e-9) << "half of 2 Ah used";
  for (int i = 0; i < 7200; ++i) {
    battery.step(1.0, {}, {});
  }
  EXPECT_NEAR(battery.volts(), 6.4, 1e-9);
}

TEST(Battery, ABlockedMotorPullsTheVoltageDown) {
  const BatteryParams params;
  Battery battery(params, battery_noise());
  battery.step(0.001, {}, {});
  const double resting_v = battery.volts();
  battery.step(0.001, {1.0, 0.0}, {1.0, 0.0});
  EXPECT_NEAR(resting_v - battery.volts(), 2.0 * 1.5 * 0.15, 1e-4);
  battery.step(0.001, {-0.8, -0.8}, {0.8, 0.8});
  EXPECT_NEAR(resting_v - battery.volts(), 2.0 * 0.8 * 0.12 * 0.8 * 0.15, 1e-4)
      << "turning freely costs little, in either direction";
}

TEST(Battery, ThePinSeesItsShareWithNoise) {
  Battery battery({}, battery_noise());
  double sum_mv = 0.0;
  double sum_of_squares = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double mv = battery.pin_millivolts();
    sum_mv += mv;
    sum_of_squares += std::pow(mv - 4200.0, 2);
  }
  EXPECT_NEAR(sum_mv / 10000.0, 4200.0, 0.1);
  EXPECT_NEAR(std::sqrt(sum_of_squares / 10000.0), 3.0, 0.1);
}

}  // namespace
}  // namespace echomap::world
