// SPDX-License-Identifier: MIT
#include "firmware/drivers/motor_bridge.hpp"

#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"

namespace echomap::drivers {
namespace {

int pin_duty() { return native::NativeBoard::instance().left_duty(); }

TEST(MotorBridge, PutsSignedDutyOnThePins) {
  MotorBridge bridge(hal::Motor::kLeft);
  bridge.set(255);
  EXPECT_EQ(pin_duty(), 255);
  bridge.set(0);
  EXPECT_EQ(pin_duty(), 0);
  bridge.set(-255);
  EXPECT_EQ(pin_duty(), -255);
  bridge.set(0);
}

TEST(MotorBridge, ReversalNeverFollowsADutyOfTheOtherDirection) {
  MotorBridge bridge(hal::Motor::kLeft);
  std::mt19937 generator(3);
  int before = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto wanted = static_cast<std::int16_t>(static_cast<int>(generator() % 511) - 255);
    bridge.set(wanted);
    EXPECT_GE(before * pin_duty(), 0);
    EXPECT_TRUE(pin_duty() == wanted || (pin_duty() == 0 && before * wanted < 0));
    before = pin_duty();
  }
  bridge.set(0);
}

TEST(MotorBridge, InversionSwapsDirectionsAndStops) {
  MotorBridge bridge(hal::Motor::kLeft);
  bridge.set(100);
  bridge.invert(true);
  EXPECT_EQ(pin_duty(), 0);
  bridge.set(100);
  EXPECT_EQ(pin_duty(), -100);
  bridge.set(0);
}

}  // namespace
}  // namespace echomap::drivers
