// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/contacts.hpp"
#include "firmware/hal/encoders.hpp"
#include "firmware/hal/motors.hpp"
#include "firmware/hal/servo.hpp"
#include "firmware/hal/sonar.hpp"

namespace echomap::hal {
namespace {

class NativeHalTest : public testing::Test {
 protected:
  NativeHalTest() { board.power_on(); }
  native::NativeBoard& board = native::NativeBoard::instance();
};

TEST_F(NativeHalTest, ClockIsSimulatedTimeInMicroseconds) {
  board.run_until_ns(7654321);
  EXPECT_EQ(now_us(), 7654U);
}

TEST_F(NativeHalTest, MotorsHaveASignByTheirDirectionPin) {
  set_motor(Motor::kLeft, true, 10);
  set_motor(Motor::kRight, false, 200);
  EXPECT_EQ(board.left_duty(), 10);
  EXPECT_EQ(board.right_duty(), -200);
}

TEST_F(NativeHalTest, ServoPulseAppears) {
  set_servo_pulse_us(1234);
  EXPECT_EQ(board.pan_pulse_us(), 1234.0);
}

TEST_F(NativeHalTest, TriggerIsToldWithItsTimeAndTheEchoPinFollows) {
  std::int64_t triggered_ns = -1;
  board.on_trigger = [&](std::int64_t at_ns) {
    triggered_ns = at_ns;
    board.schedule_echo(at_ns + 1000, at_ns + 2000);
  };
  board.run_until_ns(500000);
  trigger_sonar();
  board.on_trigger = nullptr;
  EXPECT_EQ(triggered_ns, 500000);
  board.run_until_ns(501500);
  EXPECT_TRUE(echo_is_high());
  board.run_until_ns(502500);
  EXPECT_FALSE(echo_is_high());
}

TEST_F(NativeHalTest, ContactsAndEncoderLevelsHaveTheirBits) {
  board.set_bump(true, true);
  EXPECT_EQ(pressed_contacts(), kContactRight);
  board.set_bump(true, false);
  EXPECT_EQ(pressed_contacts(), 0);
  board.schedule_encoder_edge(true, 1000, false, true);
  board.run_until_ns(1000);
  EXPECT_EQ(encoder_levels(), 0b1000);
}

}  // namespace
}  // namespace echomap::hal
