// SPDX-License-Identifier: MIT
#include "hil_mock/rp2040/pin_signals.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "hil_mock/rp2040/pico_pins.hpp"

namespace echomap::rp2040 {
namespace {

using runner::Wheel;
using world::DriverInterface;

constexpr std::uint8_t kFloating = 0;
constexpr std::uint8_t kDriven = 2;

/// An event that tells of one pin.
Message of_pin(std::uint8_t pin, std::uint8_t source, double from, double until, double period_us) {
  Message event;
  event.byte(1).byte(pin).byte(source).number(from).number(until).number(period_us);
  return event;
}

PinSignals with(Message event) {
  PinSignals signals;
  signals.take(event);
  return signals;
}

TEST(PinSignals, FloatUntilTheyAreTold) {
  const PinSignals signals;
  EXPECT_EQ(signals.driver_inputs(Wheel::kLeft, DriverInterface::kIn1In2Pwm).pwm,
            world::floating());
  EXPECT_FALSE(signals.trigger_is_high());
  EXPECT_FALSE(signals.drives_high(pico_pins::kSpare[0]));
}

TEST(PinSignals, EachDriverHasItsWires) {
  const PinSignals signals = with(of_pin(pico_pins::kRightMotorPwm, kDriven, 0.0, 0.25, 128.0));
  const world::PinSignal quarter = world::pulses(0.25, 128.0);
  for (const auto interface :
       {DriverInterface::kPhaseEnable, DriverInterface::kIn1In2Pwm, DriverInterface::kServo}) {
    EXPECT_EQ(signals.driver_inputs(Wheel::kRight, interface).pwm, quarter);
    EXPECT_EQ(signals.driver_inputs(Wheel::kLeft, interface).pwm, world::floating());
  }
  EXPECT_EQ(signals.driver_inputs(Wheel::kRight, DriverInterface::kTwoPwm).in1, quarter);
}

TEST(PinSignals, SecondInputIsNoWireOfPhaseEnable) {
  const PinSignals signals = with(of_pin(pico_pins::kLeftMotorSecond, kDriven, 0.0, 1.0, 0.0));
  EXPECT_EQ(signals.driver_inputs(Wheel::kLeft, DriverInterface::kPhaseEnable).in2,
            world::floating());
  EXPECT_EQ(signals.driver_inputs(Wheel::kLeft, DriverInterface::kIn1In2Pwm).in2,
            world::level(true));
}

TEST(PinSignals, PanPulseIsAShareOfItsPeriodAndNoneOfALevel) {
  EXPECT_DOUBLE_EQ(with(of_pin(pico_pins::kPanServo, kDriven, 0.0, 0.075, 20'000.0)).pan_pulse_us(),
                   1500.0);
  EXPECT_EQ(with(of_pin(pico_pins::kPanServo, kDriven, 0.0, 1.0, 0.0)).pan_pulse_us(), 0.0);
}

TEST(PinSignals, OnlyADrivenPinIsHigh) {
  const std::uint8_t spare = pico_pins::kSpare[0];
  EXPECT_TRUE(with(of_pin(spare, kDriven, 0.0, 1.0, 0.0)).drives_high(spare));
  EXPECT_FALSE(with(of_pin(spare, kFloating, 0.0, 1.0, 0.0)).drives_high(spare));
  EXPECT_TRUE(with(of_pin(pico_pins::kSonarTrigger, kDriven, 0.0, 1.0, 0.0)).trigger_is_high());
}

TEST(PinSignals, RefusesAPinThatTheChipHasNot) {
  EXPECT_THROW(with(of_pin(32, kDriven, 0.0, 1.0, 0.0)), std::out_of_range);
}

}  // namespace
}  // namespace echomap::rp2040
