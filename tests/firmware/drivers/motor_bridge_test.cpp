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

TEST(MotorBridge, BrakesAtZeroWhereToldAndNeverInAReversal) {
  const auto& board = native::NativeBoard::instance();
  MotorBridge bridge(hal::Motor::kLeft);
  bridge.brake_at_zero(true);
  EXPECT_FALSE(board.left_brakes()) << "nobody set a duty yet";
  bridge.set(0);
  EXPECT_TRUE(board.left_brakes());
  bridge.set(80);
  EXPECT_FALSE(board.left_brakes());
  bridge.set(-80);
  EXPECT_EQ(pin_duty(), 0);
  EXPECT_FALSE(board.left_brakes()) << "the reversal's call";
  bridge.set(-80);
  EXPECT_EQ(pin_duty(), -80);
  bridge.set(0);
  EXPECT_TRUE(board.left_brakes());
  bridge.release();
  EXPECT_FALSE(board.left_brakes());
  bridge.brake_at_zero(false);
  bridge.set(0);
  EXPECT_FALSE(board.left_brakes());
}

TEST(MotorBridge, KnowsTheOptionsOfEachKind) {
  // Of kind 0 .. 4: a bit for each value of bridge_options that it takes.
  constexpr unsigned kTaken[] = {0b0101, 0b1111, 0b1111, 0b0011, 0};
  for (int kind = 0; kind < 256; ++kind) {
    for (int options = 0; options < 256; ++options) {
      const protocol::ConfigureWiring wiring{
          0, static_cast<std::uint8_t>(kind), static_cast<std::uint8_t>(options), 0};
      const bool taken = kind < 4 && options < 4 && (kTaken[kind] >> options & 1U) != 0;
      EXPECT_EQ(can_drive(wiring), taken) << kind << ' ' << options;
    }
  }
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
