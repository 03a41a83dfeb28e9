// SPDX-License-Identifier: MIT
#include "firmware/drivers/pan_servo.hpp"

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"

namespace echomap::drivers {
namespace {

constexpr protocol::ConfigurePan kSettings{0, 0, 1500, 900, 0, -9000, 9000, 300};

double pulse_us() { return native::NativeBoard::instance().pan_pulse_us(); }

/// Until the servo has seen a new pulse.
constexpr int kPulseMs = 20;

class PanServoTest : public testing::Test {
 protected:
  protocol::ConfigurePan settings = kSettings;
  PanServo servo;
  std::uint16_t turn_to(std::int32_t pan_cdeg) { return servo.turn_to(settings, pan_cdeg); }
};

TEST_F(PanServoTest, LeftIsTheSideOfTheSettingsSign) {
  turn_to(9000);
  EXPECT_EQ(pulse_us(), 2400);
  turn_to(-4500);
  EXPECT_EQ(pulse_us(), 1050);
  settings.us_per_90deg = -900;
  turn_to(9000);
  EXPECT_EQ(pulse_us(), 600);
}

TEST_F(PanServoTest, FirstTurnMayComeFromAnywhere) {
  EXPECT_EQ(turn_to(0), kPulseMs + 600);  // 180 degrees at 300 a second.
}

TEST_F(PanServoTest, TravelIsTurnOverSpeedRoundedUp) {
  turn_to(0);
  EXPECT_EQ(turn_to(600), kPulseMs + 20);
  EXPECT_EQ(turn_to(-600), kPulseMs + 40);
  EXPECT_EQ(turn_to(-610), kPulseMs + 1);
}

TEST_F(PanServoTest, IsThereWhereThePulseStaysTheSame) {
  turn_to(0);
  EXPECT_EQ(turn_to(0), 0);
  for (int pan_cdeg = 1; pan_cdeg < 10; ++pan_cdeg) {
    EXPECT_EQ(turn_to(pan_cdeg), 0) << pan_cdeg;
  }
  EXPECT_EQ(turn_to(10), kPulseMs + 1) << "a microsecond";
}

TEST_F(PanServoTest, StandsAnywhereAfterATurnThatNobodyWaitedFor) {
  turn_to(0);
  servo.lose_track();
  EXPECT_EQ(turn_to(0), kPulseMs + 600);
}

TEST_F(PanServoTest, RefusesPulsesThatBreakServos) {
  EXPECT_TRUE(PanServo::accepts(settings));
  settings.us_per_90deg = 1101;
  EXPECT_FALSE(PanServo::accepts(settings));
  settings = kSettings;
  settings.centre_us = 1299;
  EXPECT_FALSE(PanServo::accepts(settings));
}

}  // namespace
}  // namespace echomap::drivers
