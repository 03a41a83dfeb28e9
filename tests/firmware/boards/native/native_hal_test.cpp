// SPDX-License-Identifier: MIT
#include <vector>

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"
#include "firmware/hal/adc.hpp"
#include "firmware/hal/aux_pins.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/contacts.hpp"
#include "firmware/hal/encoders.hpp"
#include "firmware/hal/motors.hpp"
#include "firmware/hal/pulses.hpp"
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

TEST_F(NativeHalTest, MotorsAtRestBrakeOrCoastAndANewBridgeSwitchesThemOff) {
  stop_motor(Motor::kLeft, true);
  set_motor(Motor::kRight, true, 50);
  EXPECT_TRUE(board.left_brakes());
  EXPECT_EQ(board.left_duty(), 0);
  use_bridge(BridgeKind::kTwoPwm, true);
  EXPECT_EQ(board.bridge_kind(), BridgeKind::kTwoPwm);
  EXPECT_TRUE(board.has_slow_pwm());
  EXPECT_FALSE(board.left_brakes());
  EXPECT_EQ(board.right_duty(), 0);
  board.power_on();
  EXPECT_EQ(board.bridge_kind(), BridgeKind::kPhaseEnable);
  EXPECT_FALSE(board.has_slow_pwm());
}

TEST_F(NativeHalTest, WheelPulsesGoFrom1000To2000Us) {
  for (int duty = 0; duty <= 255; ++duty) {
    const auto byte = static_cast<std::uint8_t>(duty);
    EXPECT_NEAR(wheel_pulse_half_us(true, byte), 3000.0 + 1000.0 * duty / 255.0, 1.0);
    EXPECT_NEAR(wheel_pulse_half_us(false, byte), 3000.0 - 1000.0 * duty / 255.0, 1.0);
  }
  EXPECT_EQ(wheel_pulse_half_us(true, 255), 4000);
  EXPECT_EQ(wheel_pulse_half_us(false, 255), 2000);
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

TEST_F(NativeHalTest, ContactsHaveTheirBitsAndEncodersCount) {
  board.set_bump(true, true);
  EXPECT_EQ(closed_contacts(), kContactRight);
  board.set_bump(true, false);
  EXPECT_EQ(closed_contacts(), 0);
  board.schedule_encoder_edge(true, 1000, false, true);
  board.run_until_ns(1000);
  EXPECT_EQ(read_encoders().right, -1);
  EXPECT_EQ(read_encoders().left, 0);
  EXPECT_EQ(encoders_read_at_us(), now_us());
}

TEST_F(NativeHalTest, SparePinsReadWhatIsPutOnThem) {
  use_aux_pin(3, PinUse::kDigital);
  use_aux_pin(15, PinUse::kDigital);
  EXPECT_EQ(aux_levels(), 1U << 3 | 1U << 15) << "their pull-ups";
  board.set_aux_level(3, false);
  board.set_aux_level(4, false);
  EXPECT_EQ(aux_levels(), 1U << 15);
  board.set_aux_level(3, true);
  board.set_aux_level(4, true);
  EXPECT_EQ(aux_levels(), 1U << 3 | 1U << 15);
}

TEST_F(NativeHalTest, OutputsStartLowAndTellEveryChange) {
  std::vector<bool> told;
  board.on_aux_output = [&](std::int64_t /*at_ns*/, std::uint8_t pin, bool high) {
    EXPECT_EQ(pin, 7);
    told.push_back(high);
  };
  use_aux_pin(7, PinUse::kOutput);
  set_aux_output(7, true);
  set_aux_output(7, true);
  EXPECT_TRUE(board.aux_output(7));
  set_aux_output(7, false);
  board.on_aux_output = nullptr;
  EXPECT_FALSE(board.aux_output(7));
  EXPECT_EQ(told, (std::vector<bool>{true, false}));
}

TEST_F(NativeHalTest, OnlyThePinWithPulsesCountsThem) {
  use_aux_pin(6, PinUse::kPulses);
  use_aux_pin(7, PinUse::kDigital);
  for (const std::uint8_t pin : std::vector<std::uint8_t>{6, 6, 7, 8}) {
    board.set_aux_level(pin, false);
    board.set_aux_level(pin, false);
    board.set_aux_level(pin, true);
  }
  EXPECT_EQ(counted_pulses(), 2);
  board.schedule_aux_pulse(6, 1000, 2000);
  board.run_until_ns(999);
  EXPECT_EQ(counted_pulses(), 2);
  board.run_until_ns(1000);
  EXPECT_EQ(counted_pulses(), 3);
  board.power_on();
  EXPECT_EQ(counted_pulses(), 0);
}

TEST_F(NativeHalTest, ConversionTakesItsTime) {
  board.set_aux_analog(9, 700);
  start_conversion(9);
  std::uint16_t value = 0;
  EXPECT_FALSE(conversion_done(value));
  board.run_until_ns(103000);
  EXPECT_FALSE(conversion_done(value));
  board.run_until_ns(104000);
  ASSERT_TRUE(conversion_done(value));
  EXPECT_EQ(value, 700);
}

}  // namespace
}  // namespace echomap::hal
