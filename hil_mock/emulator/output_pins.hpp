// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <avr_timer.h>
#include <cstdint>
#include <optional>
#include <set>
#include <sim_avr.h>
#include <vector>

#include "hil_mock/emulator/board_wiring.hpp"
#include "hil_mock/world/motor_driver.hpp"

namespace echomap::emulator {

/// An output that the program sets in PORTx and drives by DDRx.
class PortOutput {
 public:
  /// `avr` outlives the output.
  PortOutput(const avr_t& avr, Pin pin);

  /// Registers whose writes change it: PORTx, DDRx, and PINx, which toggles PORTx.
  std::array<std::uint16_t, 3> addresses() const { return {port_, direction_, toggles_}; }

  bool is_driven() const { return bit_of(direction_); }
  /// What hangs on a pin that nobody drives has a pull-down here: it sees it low, also through the
  /// chip's own pull-up.
  bool level() const { return is_driven() && bit_of(port_); }
  world::PinSignal signal() const;

 private:
  bool bit_of(std::uint16_t address) const { return ((avr_.data[address] >> bit_) & 1) != 0; }

  const avr_t& avr_;
  std::uint16_t port_;
  std::uint16_t direction_;
  std::uint16_t toggles_;
  std::uint8_t bit_;
};

/// An output that a timer sets where its compare unit is connected, and PORTx else. DDRx drives it
/// in both cases: ATmega328P data sheet, section 15.9.1 "COM0A1:0". A new OCRnx counts at once,
/// where the chip waits for the end of the period.
class PwmOutput {
 public:
  /// `avr` outlives the output.
  PwmOutput(const avr_t& avr, CompareUnit unit);

  /// Whether the program drives the pin, and the unit clears or sets it at a match.
  bool makes_pulses() const { return port_.is_driven() && is_connected(); }
  /// OCRnx.
  std::uint16_t compare() const;
  /// OCRnx, or its low byte where it has two.
  std::uint16_t compare_address() const { return timer_.comp[unit_].r_ocr; }
  /// Registers whose writes change it.
  std::set<std::uint16_t> addresses() const;
  world::PinSignal signal() const;

 private:
  bool is_connected() const;
  bool sets_at_match() const;
  double cycles_per_count() const;
  std::uint32_t top(avr_timer_wgm_t mode) const;

  const avr_t& avr_;
  const avr_timer_t& timer_;
  std::uint8_t unit_;
  PortOutput port_;
};

/// A pin that goes to a motor driver.
class DriverOutput {
 public:
  DriverOutput(const avr_t& avr, const DriverPin& pin);

  std::set<std::uint16_t> addresses() const;
  world::PinSignal signal() const;

 private:
  std::optional<PortOutput> port_;
  std::optional<PwmOutput> pwm_;
};

/// The pins of one motor.
class MotorOutput {
 public:
  MotorOutput(const avr_t& avr, const MotorWiring& wiring);

  /// Registers whose writes change one of them, whatever the driver.
  std::set<std::uint16_t> addresses() const;
  world::DriverInputs inputs(world::DriverInterface interface) const;

 private:
  /// By interface: PWM, IN1, IN2.
  std::vector<std::array<DriverOutput, 3>> drivers_;
};

}  // namespace echomap::emulator
