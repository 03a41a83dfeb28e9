// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/simavr_board.hpp"

#include <algorithm>
#include <avr_ioport.h>
#include <sim_core_config.h>
#include <sim_io.h>
#include <sim_irq.h>

#include "hil_mock/emulator/atmega328p.hpp"
#include "protocol/version.hpp"

namespace echomap::emulator {
namespace {

using runner::MotorDuty;
using runner::Wheel;

/// A cycle lasts 125/2 ns.
constexpr std::int64_t kTwoCyclesNs = 125;
/// Timer 1 counts at clk/8.
constexpr double kTimer1CountUs = 0.5;
/// Shortest trigger pulse that an HC-SR04 answers: its data sheet, "Timing diagram".
constexpr std::uint64_t kLeastTriggerCycles = kClockHz / 100'000;

constexpr std::uint8_t kCompareAConnected = 0x80;  // COMnA1: cleared on match
constexpr std::uint8_t kCompareBConnected = 0x20;  // COMnB1
constexpr std::uint8_t kClockSelect = 0x07;

std::int64_t ns_of_cycle(std::uint64_t cycle) {
  return static_cast<std::int64_t>(cycle) * kTwoCyclesNs / 2;
}

std::uint64_t cycle_at_ns(std::int64_t ns) {
  return static_cast<std::uint64_t>((ns * 2 + kTwoCyclesNs - 1) / kTwoCyclesNs);
}

struct MotorRegisters {
  std::uint16_t compare;
  std::uint8_t connected;
  Pin pwm;
  Pin forward;
};

constexpr MotorRegisters kLeftMotor{
    atmega328p::kOcr0a, kCompareAConnected, uno_pins::kLeftMotorPwm, uno_pins::kLeftMotorForward};
constexpr MotorRegisters kRightMotor{
    atmega328p::kOcr0b, kCompareBConnected, uno_pins::kRightMotorPwm, uno_pins::kRightMotorForward};

bool port_d_level(const AvrMachine& machine, Pin pin) {
  return ((machine.data_at(atmega328p::kPortD) >> pin.bit) & 1) != 0;
}

/// Mean level of the PWM pin: in fast PWM it is high for OCR + 1 of 256 counts.
double pwm_level(const AvrMachine& machine, const MotorRegisters& motor) {
  const bool connected = (machine.data_at(atmega328p::kTccr0a) & motor.connected) != 0 &&
                         (machine.data_at(atmega328p::kTccr0b) & kClockSelect) != 0;
  if (!connected) {
    return port_d_level(machine, motor.pwm) ? 1.0 : 0.0;
  }
  return (machine.data_at(motor.compare) + 1) / 256.0;
}

double duty_of(const AvrMachine& machine, const MotorRegisters& motor) {
  const double level = pwm_level(machine, motor);
  return port_d_level(machine, motor.forward) ? level : -level;
}

}  // namespace

SimavrBoard::SimavrBoard(const std::filesystem::path& elf)
    : program_(elf.stem().string()), machine_(elf) {
  machine_.usart().on_sent = [this](std::uint8_t byte) {
    if (on_sent) {
      on_sent(byte);
    }
  };
  drive_resting_levels();
  watch_trigger();
  watch_servo();
}

std::int64_t SimavrBoard::now_ns() const {
  return std::min(ns_of_cycle(machine_.cycle()), until_ns_);
}

void SimavrBoard::run_until(std::int64_t until_ns) {
  until_ns_ = std::max(until_ns_, until_ns);
  machine_.run_to(cycle_at_ns(until_ns_));
}

MotorDuty SimavrBoard::motor_duty() const {
  return {duty_of(machine_, kLeftMotor), duty_of(machine_, kRightMotor)};
}

double SimavrBoard::pan_pulse_us() const {
  const bool connected = (machine_.data_at(atmega328p::kTccr1a) & kCompareBConnected) != 0;
  return connected && servo_compare_ != 0 ? (servo_compare_ + 1) * kTimer1CountUs : 0.0;
}

void SimavrBoard::schedule_encoder_edge(Wheel wheel, std::int64_t at_ns, bool a, bool b) {
  const bool left = wheel == Wheel::kLeft;
  schedule_level(at_ns, left ? uno_pins::kLeftEncoderA : uno_pins::kRightEncoderA, a);
  schedule_level(at_ns, left ? uno_pins::kLeftEncoderB : uno_pins::kRightEncoderB, b);
}

void SimavrBoard::schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) {
  schedule_level(rise_ns, uno_pins::kSonarEcho, true);
  schedule_level(fall_ns, uno_pins::kSonarEcho, false);
}

void SimavrBoard::set_bump(Wheel side, bool pressed) {
  machine_.pins().set(side == Wheel::kLeft ? uno_pins::kLeftBump : uno_pins::kRightBump, !pressed);
}

std::string SimavrBoard::firmware_name() const {
  constexpr unsigned kVersion = protocol::kFirmwareVersion;
  return program_ + ' ' + std::to_string(kVersion / 100) + '.' +
         std::to_string(kVersion / 10 % 10) + '.' + std::to_string(kVersion % 10);
}

std::string SimavrBoard::emulator_name() const { return "simavr " CONFIG_SIMAVR_VERSION; }

void SimavrBoard::drive_resting_levels() {
  InputPins& pins = machine_.pins();
  for (const Pin encoder : {uno_pins::kLeftEncoderA,
                            uno_pins::kLeftEncoderB,
                            uno_pins::kRightEncoderA,
                            uno_pins::kRightEncoderB,
                            uno_pins::kSonarEcho}) {
    pins.set(encoder, false);
  }
  set_bump(Wheel::kLeft, false);
  set_bump(Wheel::kRight, false);
}

void SimavrBoard::watch_trigger() {
  constexpr Pin kPin = uno_pins::kSonarTrigger;
  avr_irq_register_notify(
      avr_io_getirq(&machine_.core(), AVR_IOCTL_IOPORT_GETIRQ(kPin.port), kPin.bit),
      [](avr_irq_t*, std::uint32_t level, void* board) {
        static_cast<SimavrBoard*>(board)->on_trigger_level((level & 1) != 0);
      },
      this);
}

void SimavrBoard::on_trigger_level(bool high) {
  const std::uint64_t now = machine_.cycle();
  if (high && !trigger_high_) {
    trigger_rise_cycle_ = now;
  }
  const bool ended = !high && trigger_high_ && now - trigger_rise_cycle_ >= kLeastTriggerCycles;
  trigger_high_ = high;
  if (ended && on_trigger) {
    on_trigger(now_ns());
  }
}

void SimavrBoard::watch_servo() {
  machine_.hooks().after_write(atmega328p::kOcr1bl, [this] {
    servo_compare_ = static_cast<std::uint16_t>(machine_.data_at(atmega328p::kOcr1bl) |
                                                (machine_.data_at(atmega328p::kOcr1bh) << 8));
  });
}

void SimavrBoard::schedule_level(std::int64_t at_ns, Pin pin, bool level) {
  machine_.queue().at(cycle_at_ns(at_ns), [this, pin, level] { machine_.pins().set(pin, level); });
}

}  // namespace echomap::emulator
