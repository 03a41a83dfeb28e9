// SPDX-License-Identifier: MIT
#include "hil_mock/mock_device/mock_board.hpp"

#include <algorithm>
#include <optional>

#include "protocol/version.hpp"

namespace echomap::mock_device {
namespace {

constexpr double kFullDuty = 255.0;
/// As the Uno's, of both frequencies.
constexpr double kPwmPeriodUs = 128.0;
constexpr double kSlowPwmPeriodUs = 1024.0;
/// The converter's reference is a supply of 5 V.
constexpr double kCountsPerMillivolt = 1024.0 / 5000.0;
constexpr double kMaxCounts = 1023.0;

}  // namespace

MockBoard::MockBoard() {
  board_.on_sent = [this](std::uint8_t byte) {
    if (on_sent) {
      on_sent(byte);
    }
  };
  board_.on_motor = [this] {
    if (on_duty) {
      on_duty();
    }
  };
  board_.on_trigger = [this](std::int64_t at_ns) {
    if (on_trigger) {
      on_trigger(at_ns);
    }
  };
  board_.power_on();
}

void MockBoard::receive(std::span<const std::uint8_t> bytes) {
  board_.receive(bytes.data(), bytes.size());
}

/// The native program has no pins: of the driver that it was configured for the wires get what it
/// asks for, and those of another one are low.
world::DriverInputs MockBoard::driver_inputs(runner::Wheel wheel,
                                             world::DriverInterface interface) const {
  const double period_us = board_.has_slow_pwm() ? kSlowPwmPeriodUs : kPwmPeriodUs;
  if (static_cast<std::uint8_t>(board_.bridge_kind()) != static_cast<std::uint8_t>(interface)) {
    return world::inputs_for(interface, 0.0, false, period_us);
  }
  const bool left = wheel == runner::Wheel::kLeft;
  const double duty = left ? board_.left_duty() : board_.right_duty();
  const bool brakes = left ? board_.left_brakes() : board_.right_brakes();
  return world::inputs_for(interface, duty / kFullDuty, brakes, period_us);
}

void MockBoard::schedule_encoder_edge(runner::Wheel wheel, std::int64_t at_ns, bool a, bool b) {
  board_.schedule_encoder_edge(wheel == runner::Wheel::kRight, at_ns, a, b);
}

void MockBoard::schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) {
  board_.schedule_echo(rise_ns, fall_ns);
}

void MockBoard::set_bump(runner::Wheel side, bool pressed) {
  board_.set_bump(side == runner::Wheel::kRight, pressed);
}

void MockBoard::set_aux_level(unsigned pin, bool high) {
  board_.set_aux_level(static_cast<std::uint8_t>(pin), high);
}

void MockBoard::schedule_aux_pulse(unsigned pin, std::int64_t fall_ns, std::int64_t rise_ns) {
  board_.schedule_aux_pulse(static_cast<std::uint8_t>(pin), fall_ns, rise_ns);
}

void MockBoard::set_aux_millivolts(unsigned pin, double millivolts) {
  const double counts = std::clamp(millivolts * kCountsPerMillivolt, 0.0, kMaxCounts);
  board_.set_aux_analog(static_cast<std::uint8_t>(pin), static_cast<std::uint16_t>(counts));
}

bool MockBoard::aux_output(unsigned pin) const {
  return board_.aux_output(static_cast<std::uint8_t>(pin));
}

void MockBoard::connect(world::TwoWireDevice& device) {
  board_.two_wire.on_read = [&device](std::uint8_t address,
                                      std::uint8_t first) -> std::optional<std::int16_t> {
    if (address != device.address()) {
      return std::nullopt;
    }
    const unsigned high = device.read(first);
    const unsigned low = device.read(static_cast<std::uint8_t>(first + 1));
    return static_cast<std::int16_t>(high << 8U | low);
  };
  board_.two_wire.on_write = [&device](std::uint8_t address, std::uint8_t to, std::uint8_t value) {
    const bool answers = address == device.address();
    if (answers) {
      device.write(to, value);
    }
    return answers;
  };
}

std::string MockBoard::firmware_name() const {
  return std::string("echomap-native ") + protocol::VersionText(protocol::kFirmwareVersion).text();
}

std::string MockBoard::emulator_name() const { return "mock"; }

}  // namespace echomap::mock_device
