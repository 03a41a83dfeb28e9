// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/unicorn_board.hpp"

#include <algorithm>
#include <stdexcept>

#include <unicorn/unicorn.h>

#include "protocol/version.hpp"

namespace echomap::unicorn {
namespace {

using runner::Wheel;

/// Nine cycles last 125 ns.
constexpr std::int64_t kNineCyclesNs = 125;
constexpr double kCyclesPerUs = 72.0;
/// Shortest trigger pulse that an HC-SR04 answers: its data sheet, "Timing diagram".
constexpr std::uint64_t kMinTriggerCycles = kClockHz / 100'000;

std::int64_t ns_of_cycle(std::uint64_t cycle) {
  return static_cast<std::int64_t>(cycle) * kNineCyclesNs / 9;
}

std::uint64_t cycle_at_ns(std::int64_t ns) {
  return static_cast<std::uint64_t>((ns * 9 + kNineCyclesNs - 1) / kNineCyclesNs);
}

struct MotorPins {
  unsigned channel;  ///< Of timer 3.
  Pin pwm;
  Pin direction;
  Pin second;
};

constexpr MotorPins kLeftMotor{1,
                               blue_pill_pins::kLeftMotorPwm,
                               blue_pill_pins::kLeftMotorForward,
                               blue_pill_pins::kLeftMotorSecond};
constexpr MotorPins kRightMotor{2,
                                blue_pill_pins::kRightMotorPwm,
                                blue_pill_pins::kRightMotorForward,
                                blue_pill_pins::kRightMotorSecond};

world::PinSignal pwm_of(const Stm32Chip& chip, const MotorPins& motor) {
  const GpioPort& port = chip.port(motor.pwm.port);
  return port.is_alternate(motor.pwm.number) ? chip.tim3().output(motor.channel)
                                             : port.signal(motor.pwm.number);
}

/// Of 12 bits; the supply of 3.3 V is the reference.
constexpr double kCountsPerMillivolt = 4096.0 / 3300.0;
constexpr double kMaxCounts = 4095.0;

Pin spare_pin(unsigned pin) {
  if (pin >= blue_pill_pins::kSpare.size()) {
    throw std::invalid_argument("stm32f103 has no spare pin_" + std::to_string(pin));
  }
  return blue_pill_pins::kSpare.at(pin);
}

bool is_same(Pin pin, Stm32Chip::PortName port, std::uint8_t number) {
  return pin.port == port && pin.number == number;
}

}  // namespace

UnicornBoard::UnicornBoard(const std::filesystem::path& elf)
    : program_(elf.stem().string()), chip_(elf) {
  chip_.usart().on_sent = [this](std::uint8_t byte) {
    if (on_sent) {
      on_sent(byte);
    }
  };
  chip_.on_write = chip_.on_reset = [this] {
    if (on_duty) {
      on_duty();
    }
  };
  chip_.on_level = [this](Stm32Chip::PortName port, std::uint8_t pin, bool high) {
    if (is_same(blue_pill_pins::kSonarTrigger, port, pin)) {
      on_trigger_level(high);
    }
  };
  drive_resting_levels();
}

std::int64_t UnicornBoard::now_ns() const {
  return std::min(ns_of_cycle(chip_.cycle()), until_ns_);
}

void UnicornBoard::run_until(std::int64_t until_ns) {
  until_ns_ = std::max(until_ns_, until_ns);
  chip_.run_to(cycle_at_ns(until_ns_));
}

world::DriverInputs UnicornBoard::driver_inputs(Wheel wheel,
                                                world::DriverInterface interface) const {
  const MotorPins& motor = wheel == Wheel::kLeft ? kLeftMotor : kRightMotor;
  const auto signal = [this](Pin pin) { return chip_.port(pin.port).signal(pin.number); };
  const world::PinSignal pwm = pwm_of(chip_, motor);
  switch (interface) {
    case world::DriverInterface::kPhaseEnable:
      return {pwm, signal(motor.direction), world::floating()};
    case world::DriverInterface::kIn1In2Pwm:
      return {pwm, signal(motor.direction), signal(motor.second)};
    case world::DriverInterface::kTwoPwm:
      return {world::floating(), pwm, signal(motor.second)};
    case world::DriverInterface::kServo:
      break;
  }
  return {pwm, world::floating(), world::floating()};
}

double UnicornBoard::pan_pulse_us() const {
  constexpr Pin kPin = blue_pill_pins::kPanServo;
  constexpr unsigned kChannel = 4;
  return chip_.port(kPin.port).is_alternate(kPin.number)
             ? static_cast<double>(chip_.tim1().pulse_cycles(kChannel)) / kCyclesPerUs
             : 0.0;
}

void UnicornBoard::schedule_encoder_edge(Wheel wheel, std::int64_t at_ns, bool a, bool b) {
  const bool left = wheel == Wheel::kLeft;
  schedule_level(at_ns, left ? blue_pill_pins::kLeftEncoderA : blue_pill_pins::kRightEncoderA, a);
  schedule_level(at_ns, left ? blue_pill_pins::kLeftEncoderB : blue_pill_pins::kRightEncoderB, b);
}

void UnicornBoard::schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) {
  schedule_level(rise_ns, blue_pill_pins::kSonarEcho, true);
  schedule_level(fall_ns, blue_pill_pins::kSonarEcho, false);
}

void UnicornBoard::set_bump(Wheel side, bool pressed) {
  drive(side == Wheel::kLeft ? blue_pill_pins::kLeftBump : blue_pill_pins::kRightBump, !pressed);
}

void UnicornBoard::set_aux_level(unsigned pin, bool high) { drive(spare_pin(pin), high); }

void UnicornBoard::schedule_aux_pulse(unsigned pin, std::int64_t fall_ns, std::int64_t rise_ns) {
  schedule_level(fall_ns, spare_pin(pin), false);
  schedule_level(rise_ns, spare_pin(pin), true);
}

void UnicornBoard::set_aux_millivolts(unsigned pin, double millivolts) {
  if (pin >= blue_pill_pins::kChannelOfSpare.size()) {
    throw std::invalid_argument("stm32f103's pin_" + std::to_string(pin) + " reads no voltage");
  }
  const double counts = std::clamp(millivolts * kCountsPerMillivolt, 0.0, kMaxCounts);
  chip_.adc().set_input(blue_pill_pins::kChannelOfSpare.at(pin),
                        static_cast<std::uint16_t>(counts));
}

bool UnicornBoard::aux_output(unsigned pin) const {
  const Pin spare = spare_pin(pin);
  return chip_.port(spare.port).is_driven_high(spare.number);
}

std::string UnicornBoard::firmware_name() const {
  return program_ + ' ' + protocol::VersionText(protocol::kFirmwareVersion).text();
}

std::string UnicornBoard::emulator_name() const {
  unsigned major = 0;
  unsigned minor = 0;
  uc_version(&major, &minor);
  return "unicorn " + std::to_string(major) + '.' + std::to_string(minor);
}

void UnicornBoard::drive_resting_levels() {
  for (const Pin pin : {blue_pill_pins::kLeftEncoderA,
                        blue_pill_pins::kLeftEncoderB,
                        blue_pill_pins::kRightEncoderA,
                        blue_pill_pins::kRightEncoderB,
                        blue_pill_pins::kSonarEcho}) {
    drive(pin, false);
  }
  set_bump(Wheel::kLeft, false);
  set_bump(Wheel::kRight, false);
}

void UnicornBoard::on_trigger_level(bool high) {
  const std::uint64_t now = chip_.cycle();
  if (high) {
    trigger_rise_cycle_ = now;
  } else if (now - trigger_rise_cycle_ >= kMinTriggerCycles && on_trigger) {
    on_trigger(now_ns());
  }
}

void UnicornBoard::schedule_level(std::int64_t at_ns, Pin pin, bool level) {
  chip_.queue().at(cycle_at_ns(at_ns), [this, pin, level] { drive(pin, level); });
}

}  // namespace echomap::unicorn
