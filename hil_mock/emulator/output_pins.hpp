// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <sim_avr.h>

#include "hil_mock/emulator/board_wiring.hpp"

namespace echomap::emulator {

/// An output that the program sets in PORTx.
class PortOutput {
 public:
  /// `avr` outlives the output.
  PortOutput(const avr_t& avr, Pin pin);

  bool level() const { return ((avr_.data[port_] >> bit_) & 1) != 0; }

 private:
  const avr_t& avr_;
  std::uint16_t port_;
  std::uint8_t bit_;
};

/// An output that a timer in fast PWM drives where its compare unit is connected, and PORTx else.
class PwmOutput {
 public:
  /// `avr` outlives the output.
  PwmOutput(const avr_t& avr, CompareUnit unit);

  /// Whether the unit clears the pin at a match.
  bool is_connected() const { return (bits(connection_) & kClearedAtMatch) != 0; }
  /// OCRnx.
  std::uint16_t compare() const;
  /// OCRnx, or its low byte where it has two.
  std::uint16_t compare_address() const { return compare_low_; }
  /// Mean level, with a timer that counts to 255: high for OCRnx + 1 of 256 counts.
  double mean_level() const;

 private:
  static constexpr std::uint8_t kClearedAtMatch = 2;  // COMnx1

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
  double duty() const { return forward_.level() ? pwm_.mean_level() : -pwm_.mean_level(); }

 private:
  PwmOutput pwm_;
  PortOutput forward_;
};

}  // namespace echomap::emulator
