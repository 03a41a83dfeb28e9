// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <avr_adc.h>
#include <cstdint>
#include <sim_avr.h>

#include "hil_mock/emulator/register_hooks.hpp"

namespace echomap::emulator {

/// Voltages on the converter's channels, in place of simavr's: that one has 8 of the ATmega2560's
/// 16. The supply of 5 V is the reference; simavr keeps control register, time and interrupt.
class AnalogInputs {
 public:
  AnalogInputs(avr_t& avr, RegisterHooks& hooks);

  /// Puts a voltage on a channel, 0 .. 15.
  void set(std::uint8_t channel, double millivolts) { millivolts_.at(channel) = millivolts; }

 private:
  std::uint8_t channel() const;
  std::uint16_t converted() const;

  avr_t& avr_;
  avr_adc_t& converter_;
  std::array<double, 16> millivolts_{};
  std::uint8_t held_high_ = 0;  ///< ADCH, from a read of ADCL on.
};

}  // namespace echomap::emulator
