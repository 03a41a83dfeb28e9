// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <sim_avr.h>

#include "hil_mock/emulator/board_wiring.hpp"

namespace echomap::emulator {

/// An output that the program sets in PORTx and drives by DDRx. What hangs on a pin that nobody
/// drives has a pull-down: it sees it low, also through the chip's own pull-up.
class PortOutput {
 public:
  /// `avr` outlives the output.
  PortOutput(const avr_t& avr, Pin pin);

  /// PORTx and DDRx.
  std::array<std::uint16_t, 2> addresses() const { return {port_, direction_}; }

  bool is_driven() const { return bit_of(direction_); }
  bool level() const { return is_driven() && bit_of(port_); }

 private:
  bool bit_of(std::uint16_t address) const { return ((avr_.data[address] >> bit_) & 1) != 0; }

  const avr_t& avr_;
  std::uint16_t port_;
  std::uint16_t direction_;
  std::uint8_t bit_;
};

/// An output that a timer in fast PWM sets where its compare unit is connected, and PORTx else.
/// DDRx drives it in both cases: ATmega328P data sheet, section 15.9.1 "COM0A1:0".
class PwmOutput {
 public:
  /// `avr` outlives the output.
  PwmOutput(const avr_t& avr, CompareUnit unit);

  /// Whether the program drives the pin, and the unit clears it at a match.
  bool makes_pulses() const { return port_.is_driven() && is_connected(); }
  /// OCRnx.
  std::uint16_t compare() const;
  /// OCRnx, or its low byte where it has two.
  std::uint16_t compare_address() const { return compare_low_; }
  /// OCRnx, the register that connects the unit, PORTx and DDRx.
  std::array<std::uint16_t, 4> addresses() const;
  /// Mean level, with a timer that counts to 255: high for OCRnx + 1 of 256 counts.
  double mean_level() const;

 private:
  static constexpr std::uint8_t kClearedAtMatch = 2;  // COMnx1

  bool is_connected() const { return (bits(connection_) & kClearedAtMatch) != 0; }
  bool is_clocked() const;
  std::uint8_t bits(avr_regbit_t which) const {
    return static_cast<std::uint8_t>((avr_.data[which.reg] >> which.bit) & which.mask);
  }

  const avr_t& avr_;
  PortOutput port_;
  std::uint16_t compare_low_;
  std::uint16_t compare_high_;  // 0 for none
  avr_regbit_t connection_;
  avr_regbit_t clock_select_[3];
};

/// What a motor bridge is told.
class MotorOutput {
 public:
  MotorOutput(const avr_t& avr, const MotorWiring& wiring)
      : pwm_(avr, wiring.pwm), forward_(avr, wiring.forward) {}

  /// Mean level of the PWM pin, negative for backwards.
  /// Registers whose writes change it.
  std::array<std::uint16_t, 6> addresses() const;

  double duty() const { return forward_.level() ? pwm_.mean_level() : -pwm_.mean_level(); }

 private:
  PwmOutput pwm_;
  PortOutput forward_;
};

}  // namespace echomap::emulator
