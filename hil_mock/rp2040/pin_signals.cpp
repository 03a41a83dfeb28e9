// SPDX-License-Identifier: MIT
#include "hil_mock/rp2040/pin_signals.hpp"

#include "hil_mock/rp2040/pico_pins.hpp"

namespace echomap::rp2040 {
namespace {

using runner::Wheel;

world::PinSignal take_signal(Message& events) {
  const std::uint8_t source = events.take_byte();
  const double from = events.take_number();
  const double until = events.take_number();
  const double period_us = events.take_number();
  switch (source) {
    case 0:
      return world::floating();
    case 1:
      return world::pulled_up();
    default:
      return {world::PinSignal::Source::kDriven, from, until, period_us};
  }
}

}  // namespace

void PinSignals::take(Message& events) {
  for (std::uint8_t left = events.take_byte(); left > 0; --left) {
    const std::uint8_t pin = events.take_byte();
    signals_.at(pin) = take_signal(events);
  }
}

bool PinSignals::trigger_is_high() const {
  return signals_.at(pico_pins::kSonarTrigger).high_share() > 0.0;
}

bool PinSignals::drives_high(std::uint8_t pin) const {
  const world::PinSignal& signal = signals_.at(pin);
  return signal.source == world::PinSignal::Source::kDriven && signal.high_share() >= 1.0;
}

world::DriverInputs PinSignals::driver_inputs(Wheel wheel, world::DriverInterface interface) const {
  const bool left = wheel == Wheel::kLeft;
  const auto& pwm = signals_.at(left ? pico_pins::kLeftMotorPwm : pico_pins::kRightMotorPwm);
  const auto& forward =
      signals_.at(left ? pico_pins::kLeftMotorForward : pico_pins::kRightMotorForward);
  const auto& second =
      signals_.at(left ? pico_pins::kLeftMotorSecond : pico_pins::kRightMotorSecond);
  switch (interface) {
    case world::DriverInterface::kPhaseEnable:
      return {pwm, forward, world::floating()};
    case world::DriverInterface::kIn1In2Pwm:
      return {pwm, forward, second};
    case world::DriverInterface::kTwoPwm:
      return {world::floating(), pwm, second};
    case world::DriverInterface::kServo:
      break;
  }
  return {pwm, world::floating(), world::floating()};
}

double PinSignals::pan_pulse_us() const {
  const world::PinSignal& servo = signals_.at(pico_pins::kPanServo);
  return servo.makes_pulses() ? servo.high_share() * servo.period_us : 0.0;
}

}  // namespace echomap::rp2040
