// SPDX-License-Identifier: MIT
#include "firmware/drivers/spare_pins.hpp"

#include "firmware/hal/aux_pins.hpp"
#include "firmware/hal/code_size.hpp"

namespace echomap {
namespace drivers {

using hal::PinUse;
using protocol::ConfigurePins;
namespace {

constexpr uint8_t kPins = 16;
constexpr uint8_t kPhases = 4;
constexpr uint8_t kHazards = 7;
static_assert(sizeof(ConfigurePins) == 1 + kPins, "the pins stand behind the command id");

/// What pin N shall do stands here at N. The message is nothing but bytes.
const uint8_t* functions(const ConfigurePins& settings) {
  return reinterpret_cast<const uint8_t*>(&settings) + 1;
}

uint8_t without_level(uint8_t function) {
  return function & static_cast<uint8_t>(~protocol::kPinActiveHigh);
}

/// The bit's number of protocol::Hazard; kHazards or more for a function that is none.
uint8_t hazard_of(uint8_t function) { return function - protocol::kPinCliffLeft; }

/// False for a function that does not exist.
bool find_use(uint8_t function, PinUse& use) {
  use = PinUse::kUnused;
  if (function >= protocol::kPinStepperPhaseA) {
    use = PinUse::kOutput;
    return function < protocol::kPinStepperPhaseA + kPhases;
  }
  if (function >= protocol::kPinRange0) {
    use = PinUse::kAnalog;
    return function < protocol::kPinRange0 + 8;
  }
  if (function != protocol::kPinUnused) {
    use = function == protocol::kPinBattery ? PinUse::kAnalog : PinUse::kDigital;
  }
  return function <= protocol::kPinBattery;
}

}  // namespace

bool SparePins::accepts(const ConfigurePins& settings) {
  for (uint8_t pin = 0; pin < kPins; ++pin) {
    PinUse use;
    const uint8_t function = without_level(functions(settings)[pin]);
    if (function != protocol::kPinUnused &&
        !(find_use(function, use) && hal::aux_pin_can(pin, use))) {
      return false;
    }
  }
  return true;
}

void SparePins::configure(const ConfigurePins& settings) {
  settings_ = settings;
  watches_hazards_ = false;
  for (uint8_t pin = 0; pin < hal::aux_pin_count(); ++pin) {
    PinUse use;
    const uint8_t function = without_level(functions(settings)[pin]);
    find_use(function, use);
    hal::use_aux_pin(pin, use);
    watches_hazards_ |= hazard_of(function) < kHazards;
  }
}

ECHOMAP_ONE_PIECE uint8_t SparePins::find(uint8_t function) const {
  for (uint8_t pin = 0; pin < hal::aux_pin_count(); ++pin) {
    if (functions(settings_)[pin] == function) {
      return pin;
    }
  }
  return kNone;
}

uint8_t SparePins::active_hazards() const {
  if (!watches_hazards_) {
    return 0;
  }
  uint16_t levels = hal::aux_levels();
  uint8_t hazards = 0;
  for (uint8_t pin = 0; pin < hal::aux_pin_count(); ++pin) {
    const uint8_t function = functions(settings_)[pin];
    const bool active_high = (function & protocol::kPinActiveHigh) != 0;
    const uint8_t number = hazard_of(without_level(function));
    if (number < kHazards && ((levels & 1) != 0) == active_high) {
      hazards |= 1U << number;
    }
    levels >>= 1;
  }
  return hazards;
}

bool SparePins::has_stepper() const {
  for (uint8_t phase = 0; phase < kPhases; ++phase) {
    if (find(protocol::kPinStepperPhaseA + phase) == kNone) {
      return false;
    }
  }
  return true;
}

void SparePins::set_stepper_phases(uint8_t levels) const {
  for (uint8_t pin = 0; pin < hal::aux_pin_count(); ++pin) {
    const uint8_t phase = functions(settings_)[pin] - protocol::kPinStepperPhaseA;
    if (phase < kPhases) {
      hal::set_aux_output(pin, ((levels >> phase) & 1) != 0);
    }
  }
}

}  // namespace drivers
}  // namespace echomap
