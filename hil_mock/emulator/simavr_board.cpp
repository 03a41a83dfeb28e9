// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/simavr_board.hpp"

#include <algorithm>
#include <set>
#include <sim_core_config.h>
#include <stdexcept>

#include "hil_mock/emulator/chip_modules.hpp"
#include "hil_mock/emulator/elf_program.hpp"
#include "protocol/version.hpp"

namespace echomap::emulator {
namespace {

using runner::Wheel;

/// A cycle lasts 125/2 ns.
constexpr std::int64_t kTwoCyclesNs = 125;
/// The timer of the servo counts at clk/8.
constexpr double kServoCountUs = 0.5;
/// Shortest trigger pulse that an HC-SR04 answers: its data sheet, "Timing diagram".
constexpr std::uint64_t kMinTriggerCycles = kClockHz / 100'000;

std::int64_t ns_of_cycle(std::uint64_t cycle) {
  return static_cast<std::int64_t>(cycle) * kTwoCyclesNs / 2;
}

std::uint64_t cycle_at_ns(std::int64_t ns) {
  return static_cast<std::uint64_t>((ns * 2 + kTwoCyclesNs - 1) / kTwoCyclesNs);
}

}  // namespace

SimavrBoard::SimavrBoard(const std::filesystem::path& elf)
    : program_(elf.stem().string()),
      wiring_(wiring_of_chip(chip_of_elf(elf))),
      machine_(elf),
      left_motor_(machine_.core(), wiring_.left_motor),
      right_motor_(machine_.core(), wiring_.right_motor),
      servo_(machine_.core(), wiring_.pan_servo),
      two_wire_bus_(machine_, wiring_.two_wire),
      trigger_(machine_.core(), wiring_.sonar_trigger) {
  machine_.usart().on_sent = [this](std::uint8_t byte) {
    if (on_sent) {
      on_sent(byte);
    }
  };
  drive_resting_levels();
  watch_trigger();
  watch_servo();
  watch_motors();
}

std::int64_t SimavrBoard::now_ns() const {
  return std::min(ns_of_cycle(machine_.cycle()), until_ns_);
}

void SimavrBoard::run_until(std::int64_t until_ns) {
  until_ns_ = std::max(until_ns_, until_ns);
  machine_.run_to(cycle_at_ns(until_ns_));
}

world::DriverInputs SimavrBoard::driver_inputs(Wheel wheel,
                                               world::DriverInterface interface) const {
  return (wheel == Wheel::kLeft ? left_motor_ : right_motor_).inputs(interface);
}

double SimavrBoard::pan_pulse_us() const {
  return servo_.makes_pulses() && servo_compare_ != 0 ? (servo_compare_ + 1) * kServoCountUs : 0.0;
}

void SimavrBoard::schedule_encoder_edge(Wheel wheel, std::int64_t at_ns, bool a, bool b) {
  const bool left = wheel == Wheel::kLeft;
  schedule_level(at_ns, left ? wiring_.left_encoder_a : wiring_.right_encoder_a, a);
  schedule_level(at_ns, left ? wiring_.left_encoder_b : wiring_.right_encoder_b, b);
}

void SimavrBoard::schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) {
  schedule_level(rise_ns, wiring_.sonar_echo, true);
  schedule_level(fall_ns, wiring_.sonar_echo, false);
}

void SimavrBoard::set_bump(Wheel side, bool pressed) {
  machine_.pins().set(side == Wheel::kLeft ? wiring_.left_bump : wiring_.right_bump, !pressed);
}

void SimavrBoard::set_aux_level(unsigned pin, bool high) {
  machine_.pins().set(digital_pin(pin), high);
}

void SimavrBoard::schedule_aux_pulse(unsigned pin, std::int64_t fall_ns, std::int64_t rise_ns) {
  const Pin wire = digital_pin(pin);
  schedule_level(fall_ns, wire, false);
  schedule_level(rise_ns, wire, true);
}

void SimavrBoard::set_aux_millivolts(unsigned pin, double millivolts) {
  const SparePin& spare = spare_pin(pin);
  if (spare.channel == SparePin::kNoChannel) {
    throw std::invalid_argument(board_name() + "'s pin_" + std::to_string(pin) +
                                " reads no voltage");
  }
  machine_.analog().set(static_cast<std::uint8_t>(spare.channel), millivolts);
}

bool SimavrBoard::aux_output(unsigned pin) const {
  const Pin spare = spare_pin(pin).pin;
  return spare.port != SparePin::kNoPort && PortOutput(machine_.core(), spare).level();
}

void SimavrBoard::connect(world::TwoWireDevice& device) {
  machine_.two_wire().connect(device);
  two_wire_bus_.pull_up();
}

Pin SimavrBoard::digital_pin(unsigned pin) const {
  const SparePin& spare = spare_pin(pin);
  if (spare.pin.port == SparePin::kNoPort) {
    throw std::invalid_argument(board_name() + "'s pin_" + std::to_string(pin) +
                                " reads voltages only");
  }
  return spare.pin;
}

const SparePin& SimavrBoard::spare_pin(unsigned pin) const {
  if (pin >= wiring_.spare_count) {
    throw std::invalid_argument(board_name() + " has no spare pin_" + std::to_string(pin));
  }
  return wiring_.spare.at(pin);
}

std::string SimavrBoard::firmware_name() const {
  return program_ + ' ' + protocol::VersionText(protocol::kFirmwareVersion).text();
}

std::string SimavrBoard::emulator_name() const { return "simavr " CONFIG_SIMAVR_VERSION; }

void SimavrBoard::drive_resting_levels() {
  InputPins& pins = machine_.pins();
  for (const Pin encoder : {wiring_.left_encoder_a,
                            wiring_.left_encoder_b,
                            wiring_.right_encoder_a,
                            wiring_.right_encoder_b,
                            wiring_.sonar_echo}) {
    pins.set(encoder, false);
  }
  set_bump(Wheel::kLeft, false);
  set_bump(Wheel::kRight, false);
}

void SimavrBoard::watch_trigger() {
  const avr_ioport_t& port = find_port(machine_.core(), wiring_.sonar_trigger.port);
  for (const std::uint16_t address : {port.r_port, port.r_ddr, port.r_pin}) {
    machine_.hooks().after_write(address, [this] { on_trigger_level(trigger_.level()); });
  }
}

void SimavrBoard::on_trigger_level(bool high) {
  const std::uint64_t now = machine_.cycle();
  if (high && !trigger_high_) {
    trigger_rise_cycle_ = now;
  }
  const bool ended = !high && trigger_high_ && now - trigger_rise_cycle_ >= kMinTriggerCycles;
  trigger_high_ = high;
  if (ended && on_trigger) {
    on_trigger(now_ns());
  }
}

void SimavrBoard::watch_servo() {
  machine_.hooks().after_write(servo_.compare_address(),
                               [this] { servo_compare_ = servo_.compare(); });
}

void SimavrBoard::watch_motors() {
  std::set<std::uint16_t> registers;
  for (const MotorOutput* motor : {&left_motor_, &right_motor_}) {
    registers.merge(motor->addresses());
  }
  for (const std::uint16_t address : registers) {
    machine_.hooks().after_write(address, [this] { tell_duty(); });
  }
  machine_.on_reset = [this] { tell_duty(); };
}

void SimavrBoard::tell_duty() const {
  if (on_duty) {
    on_duty();
  }
}

void SimavrBoard::schedule_level(std::int64_t at_ns, Pin pin, bool level) {
  machine_.queue().at(cycle_at_ns(at_ns), [this, pin, level] { machine_.pins().set(pin, level); });
}

}  // namespace echomap::emulator
