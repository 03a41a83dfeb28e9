// SPDX-License-Identifier: MIT
#include "firmware/drivers/spare_pins.hpp"

#include "firmware/hal/aux_pins.hpp"

namespace echomap {
namespace drivers {

using hal::PinUse;
using protocol::ConfigurePins;
namespace {

constexpr uint8_t kPins = 16;
constexpr uint8_t kPhases = 4;
static_assert(protocol::kPinStepperPhaseA % kPhases == 0, "the low bits number the phases");
static_assert(sizeof(ConfigurePins) == 1 + kPins, "the pins stand behind the command id");

/// What pin N shall do stands here at N. The message is nothing but bytes.
const uint8_t* functions(const ConfigurePins& settings) {
  return reinterpret_cast<const uint8_t*>(&settings) + 1;
}

/// The bit of a hazard that a digital input shows; 7 and more for every other function.
uint8_t hazard_number(uint8_t function) {
  const uint8_t plain = function & static_cast<uint8_t>(~protocol::kPinActiveHigh);
  return static_cast<uint8_t>(plain - protocol::kPinCliffLeft);
}

bool is_hazard(uint8_t function) { return hazard_number(function) < 7; }

bool is_phase(uint8_t function) {
  return static_cast<uint8_t>(function - protocol::kPinStepperPhaseA) < kPhases;
}

PinUse use_of(uint8_t function) {
  if (is_hazard(function)) {
    return PinUse::kDigital;
  }
  if (SparePins::is_analog(function)) {
    return PinUse::kAnalog;
  }
  if (function == protocol::kPinScalarPulses) {
    return PinUse::kPulses;
  }
  return is_phase(function) ? PinUse::kOutput : PinUse::kUnused;
}

}  // namespace

bool SparePins::accepts(const ConfigurePins& settings) const {
  for (uint8_t pin = 0; pin < kPins; ++pin) {
    const uint8_t function = functions(settings)[pin];
    const PinUse use = use_of(function);
    const bool possible = use != PinUse::kUnused && !is_taken(pin) && hal::aux_pin_can(pin, use);
    if (function != protocol::kPinUnused && !possible) {
      return false;
    }
  }
  return true;
}

void SparePins::configure(const ConfigurePins& settings) {
  settings_ = settings;
  used_ = 0;
  use_twi_pins_ = false;
  for (uint8_t pin = 0; pin < hal::aux_pin_count(); ++pin) {
    const PinUse use = use_of(function(pin));
    if (!is_taken(pin)) {
      hal::use_aux_pin(pin, use);
    }
    if (use != PinUse::kUnused) {
      used_ = static_cast<uint8_t>(pin + 1);
      use_twi_pins_ |= hal::aux_pin_is_twi(pin);
    }
  }
}

bool SparePins::can_take(uint16_t pins) const {
  for (uint8_t pin = 0; pin < used_; ++pin) {
    if ((pins >> pin & 1) != 0 && function(pin) != protocol::kPinUnused) {
      return false;
    }
  }
  return true;
}

void SparePins::take(uint16_t pins) {
  const uint16_t back = taken_ & static_cast<uint16_t>(~pins);
  taken_ = pins;
  for (uint8_t pin = 0; pin < kPins; ++pin) {
    if ((back >> pin & 1) != 0) {
      hal::use_aux_pin(pin, PinUse::kUnused);
    }
  }
}

uint8_t SparePins::function(uint8_t pin) const { return functions(settings_)[pin]; }

uint8_t SparePins::active_hazards() const {
  uint16_t levels = hal::aux_levels();
  uint8_t hazards = 0;
  for (uint8_t pin = 0; pin < used_; ++pin) {
    const uint8_t what = function(pin);
    const bool active_high = (what & protocol::kPinActiveHigh) != 0;
    if (is_hazard(what) && ((levels & 1) != 0) == active_high) {
      hazards = static_cast<uint8_t>(hazards | (1U << hazard_number(what)));
    }
    levels >>= 1;
  }
  return hazards;
}

bool SparePins::has_stepper() const {
  uint8_t phases = 0;
  for (uint8_t pin = 0; pin < used_; ++pin) {
    const uint8_t what = function(pin);
    if (is_phase(what)) {
      phases = static_cast<uint8_t>(phases | (1U << (what & (kPhases - 1))));
    }
  }
  return phases == (1U << kPhases) - 1;
}

void SparePins::set_stepper_phases(uint8_t levels) const {
  for (uint8_t pin = 0; pin < used_; ++pin) {
    const uint8_t what = function(pin);
    if (is_phase(what)) {
      hal::set_aux_output(pin, ((levels >> (what & (kPhases - 1))) & 1) != 0);
    }
  }
}

}  // namespace drivers
}  // namespace echomap
