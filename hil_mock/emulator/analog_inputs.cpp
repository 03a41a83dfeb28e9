// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/analog_inputs.hpp"

#include <algorithm>
#include <sim_regbit.h>

#include "hil_mock/emulator/chip_modules.hpp"

namespace echomap::emulator {
namespace {

constexpr double kCountsPerMillivolt = 1024.0 / 5000.0;

}  // namespace

AnalogInputs::AnalogInputs(avr_t& avr, RegisterHooks& hooks)
    : avr_(avr), converter_(find_converter(avr)) {
  hooks.replace_read(converter_.r_adcl, [this] {
    const std::uint16_t value = converted();
    held_high_ = static_cast<std::uint8_t>(value >> 8U);
    return static_cast<std::uint8_t>(value & 0xFFU);
  });
  hooks.replace_read(converter_.r_adch, [this] { return held_high_; });
}

/// MUX2 .. 0, and MUX5 for the upper half of an ATmega2560's.
std::uint8_t AnalogInputs::channel() const {
  const auto bit = [this](std::size_t index) -> unsigned {
    const avr_regbit_t& mux = converter_.mux[index];
    return mux.reg == 0 ? 0U : avr_regbit_get(&avr_, mux);
  };
  return static_cast<std::uint8_t>(bit(5) << 3U | bit(2) << 2U | bit(1) << 1U | bit(0));
}

std::uint16_t AnalogInputs::converted() const {
  const double counts = millivolts_.at(channel()) * kCountsPerMillivolt;
  return static_cast<std::uint16_t>(std::clamp(counts, 0.0, 1023.0));
}

}  // namespace echomap::emulator
