// SPDX-License-Identifier: MIT
#include "host/session/scalar_profile.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "host/session/profile_fields.hpp"
#include "protocol/limits.hpp"

namespace echomap::session {
namespace {

constexpr double kMinPeriodMs = 10.0;
constexpr double kSecondsPerUs = 1e-6;

/// Whether a pin has the function; a visitor of the pins' message.
struct FindPin {
  unsigned function;
  bool found = false;
  void operator()(std::string_view name, std::uint8_t pin) {
    found = found || (name != "command_id" && pin == function);
  }
};

bool has_pin(const protocol::ConfigurePins& pins, unsigned function) {
  FindPin find{function};
  protocol::ConfigurePins::each(pins, find);
  return find.found;
}

double at_least_zero(const files::TomlReader& table, std::string_view key) {
  const double value = table.number(key);
  if (value < 0.0) {
    table.fail(key, "'" + std::string(key) + "' must not be negative");
  }
  return value;
}

void read_pulses(const files::TomlReader& table, sensors::ScalarParams& scalar) {
  scalar.unit = table.text_or("unit", "pulses/s");
  if (table.has("dead_time_us")) {
    scalar.dead_time_s = kSecondsPerUs * at_least_zero(table, "dead_time_us");
  }
  if (table.has("background_per_s")) {
    scalar.background_per_s = at_least_zero(table, "background_per_s");
  }
}

void read_level(const files::TomlReader& table, sensors::ScalarParams& scalar) {
  scalar.unit = table.text("unit");
  scalar.zero = table.number_or("zero", 0.0);
  scalar.full_scale = table.number("full_scale");
  if (scalar.full_scale == scalar.zero) {
    table.fail("full_scale", "'full_scale' and 'zero' must differ");
  }
}

}  // namespace

void read_scalar(const files::TomlReader& table, RobotProfile& profile) {
  sensors::ScalarParams scalar;
  const std::string kind = table.text("kind");
  if (kind != "pulses" && kind != "level") {
    table.fail("kind", "'kind' must be \"pulses\" or \"level\"");
  }
  scalar.kind = kind == "pulses" ? sensors::ScalarKind::kPulses : sensors::ScalarKind::kLevel;
  const unsigned function = scalar.kind == sensors::ScalarKind::kPulses ? protocol::kPinScalarPulses
                                                                        : protocol::kPinScalarLevel;
  if (!has_pin(profile.configuration.pins, function)) {
    table.fail("kind", "no pin of [wiring] is 'scalar_" + kind + "'");
  }
  if (scalar.kind == sensors::ScalarKind::kPulses) {
    read_pulses(table, scalar);
  } else {
    read_level(table, scalar);
  }
  profile.configuration.scalar.period_ms =
      field<std::uint16_t>(table, "period_ms", 1.0, {kMinPeriodMs, protocol::kMaxScalarPeriodMs});
  profile.sensors.scalar = std::move(scalar);
}

bool wants_scalar(const protocol::Configuration& configuration) {
  return configuration.scalar.period_ms != 0 ||
         has_pin(configuration.pins, protocol::kPinScalarPulses) ||
         has_pin(configuration.pins, protocol::kPinScalarLevel);
}

std::string advice_on_refused_scalar(std::uint32_t capabilities) {
  if ((capabilities & protocol::kCapabilityScalar) == 0) {
    return "it has no pin for its scalar sensor: an EV3 has ports in place of spare pins, and "
           "neither counts pulses nor reads a voltage\n"
           "  next: take a board with spare pins (Uno, Mega, STM32F103, Pico), or leave [scalar] "
           "and its pin out of the profile";
  }
  return "a pin cannot be what [wiring] says\n"
         "  next: put 'scalar_pulses' on pin_0 .. pin_2 (D11 .. D13) of an Uno or Nano, pin_8 .. "
         "pin_15 (A8 .. A15) of a Mega, or any spare pin of an STM32F103 or a Pico, and "
         "'scalar_level' on a pin that its page in docs/hardware calls analog";
}

}  // namespace echomap::session
