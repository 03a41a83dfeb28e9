// SPDX-License-Identifier: MIT
#include "host/session/sensor_profile.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "host/files/nearest_word.hpp"
#include "host/geometry/angle.hpp"
#include "host/session/profile_fields.hpp"
#include "host/session/scalar_profile.hpp"
#include "protocol/limits.hpp"

namespace echomap::session {
namespace {

using files::TomlReader;

struct PinWord {
  std::string_view word;
  std::uint8_t function;
};

constexpr std::array kPinWords{PinWord{"cliff_left", protocol::kPinCliffLeft},
                               PinWord{"cliff_front_left", protocol::kPinCliffFrontLeft},
                               PinWord{"cliff_front_right", protocol::kPinCliffFrontRight},
                               PinWord{"cliff_right", protocol::kPinCliffRight},
                               PinWord{"wheel_drop", protocol::kPinWheelDrop},
                               PinWord{"virtual_wall", protocol::kPinVirtualWall},
                               PinWord{"wall", protocol::kPinWall},
                               PinWord{"battery", protocol::kPinBattery},
                               PinWord{"scalar_level", protocol::kPinScalarLevel},
                               PinWord{"scalar_pulses", protocol::kPinScalarPulses},
                               PinWord{"range_0", protocol::kPinRange0},
                               PinWord{"range_1", protocol::kPinRange0 + 1},
                               PinWord{"range_2", protocol::kPinRange0 + 2},
                               PinWord{"range_3", protocol::kPinRange0 + 3},
                               PinWord{"range_4", protocol::kPinRange0 + 4},
                               PinWord{"range_5", protocol::kPinRange0 + 5},
                               PinWord{"range_6", protocol::kPinRange0 + 6},
                               PinWord{"range_7", protocol::kPinRange0 + 7},
                               PinWord{"stepper_a", protocol::kPinStepperPhaseA},
                               PinWord{"stepper_b", protocol::kPinStepperPhaseA + 1},
                               PinWord{"stepper_c", protocol::kPinStepperPhaseA + 2},
                               PinWord{"stepper_d", protocol::kPinStepperPhaseA + 3}};
constexpr std::string_view kHigh = " high";

using Pins = std::array<std::uint8_t, 16>;

std::uint8_t pin_function(const TomlReader& wiring, const std::string& key) {
  std::string word = wiring.text(key);
  std::uint8_t flags = 0;
  if (word.ends_with(kHigh)) {
    word.resize(word.size() - kHigh.size());
    flags = protocol::kPinActiveHigh;
  }
  const auto found = std::ranges::find(kPinWords, word, &PinWord::word);
  if (found == kPinWords.end()) {
    std::vector<std::string> words;
    words.reserve(kPinWords.size());
    for (const PinWord& one : kPinWords) {
      words.emplace_back(one.word);
    }
    wiring.fail(key, "no pin is a '" + word + "'" + files::suggestion(word, words));
  }
  if (flags != 0 && found->function > protocol::kPinWall) {
    wiring.fail(key, "'" + word + "' has no level to be high: leave ' high' out");
  }
  return static_cast<std::uint8_t>(found->function | flags);
}

Pins read_pins(const TomlReader& wiring) {
  Pins pins{};
  const auto same_part = [](std::uint8_t one, std::uint8_t other) {
    return ((one ^ other) & ~protocol::kPinActiveHigh) == 0;
  };
  for (std::size_t i = 0; i < pins.size(); ++i) {
    const std::string key = "pin_" + std::to_string(i);
    if (!wiring.has(key)) {
      continue;
    }
    const std::uint8_t function = pin_function(wiring, key);
    if (std::ranges::any_of(pins, [&](std::uint8_t pin) { return same_part(pin, function); })) {
      wiring.fail(key, "another pin is '" + wiring.text(key) + "' already");
    }
    pins.at(i) = function;
  }
  return pins;
}

/// Writes the pins into the message field by field; a visitor of its fields.
struct PutPins {
  const Pins& pins;
  std::size_t next = 0;
  void operator()(std::string_view name, std::uint8_t& pin) {
    if (name != "command_id") {
      pin = pins.at(next++);
    }
  }
};

bool has_pin(const Pins& pins, unsigned function) {
  return std::ranges::find(pins, function) != pins.end();
}

void validate_pin(const Pins& pins,
                  unsigned function,
                  const TomlReader& table,
                  std::string_view key,
                  const std::string& word) {
  if (!has_pin(pins, function)) {
    table.fail(key, "no pin of [wiring] is '" + word + "'");
  }
}

sensors::InfraredCurve read_curve(const TomlReader& infrared) {
  std::vector<sensors::InfraredPoint> points;
  for (const auto& [counts, range_m] : infrared.points("curve")) {
    points.push_back({counts, range_m});
  }
  try {
    return sensors::InfraredCurve(points);
  } catch (const std::invalid_argument&) {
    infrared.fail("curve",
                  "'curve' must hold two pairs [counts, metres] or more, the nearest first: counts "
                  "fall, ranges grow");
  }
}

sensors::InfraredSensor read_infrared_sensor(const TomlReader& table, const Pins& pins) {
  const auto channel = field<std::uint8_t>(table, "channel", 1.0, {0, 7});
  validate_pin(
      pins, protocol::kPinRange0 + channel, table, "channel", "range_" + std::to_string(channel));
  return {
      channel,
      {table.number("x_m"), table.number("y_m"), geometry::radians(table.number("direction_deg"))}};
}

void read_infrared(const TomlReader& table, const Pins& pins, RobotProfile& profile) {
  profile.configuration.sensors.ranges_period_ms =
      field<std::uint8_t>(table, "period_ms", 1.0, {1, UINT8_MAX});
  profile.sensors.infrared_curve = read_curve(table);
  for (const TomlReader& sensor : table.tables("sensor")) {
    profile.sensors.infrared.push_back(read_infrared_sensor(sensor, pins));
  }
}

void read_gyro(const TomlReader& table, RobotProfile& profile) {
  constexpr std::array kFullScalesDegPerS{250.0, 500.0, 1000.0, 2000.0};
  const double full_scale_deg_per_s = table.number("full_scale_deg_per_s");
  const auto found = std::ranges::find(kFullScalesDegPerS, full_scale_deg_per_s);
  if (found == kFullScalesDegPerS.end()) {
    table.fail("full_scale_deg_per_s", "an MPU-6050 has 250, 500, 1000 and 2000 degrees a second");
  }
  protocol::ConfigureSensors& settings = profile.configuration.sensors;
  settings.gyro_range = static_cast<std::uint8_t>(found - kFullScalesDegPerS.begin());
  settings.gyro_period_ms =
      field<std::uint8_t>(table, "period_ms", 1.0, {protocol::kMinGyroPeriodMs, UINT8_MAX});
  profile.sensors.gyro = sensors::GyroParams{geometry::radians(full_scale_deg_per_s),
                                             1e-3 * settings.gyro_period_ms,
                                             table.boolean_or("upside_down", false)};
}

/// Cliffs and a wheel-drop always stop the wheels; where no pin reads them they never come.
void read_safety(const TomlReader& table, RobotProfile& profile) {
  protocol::ConfigureSafety& safety = profile.configuration.safety;
  const auto stop_at = [&](std::string_view key, std::uint8_t bit) {
    const bool stops = table.boolean_or(key, false);
    safety.hazard_stops = static_cast<std::uint8_t>(safety.hazard_stops | (stops ? bit : 0));
  };
  stop_at("stop_at_virtual_wall", protocol::kHazardVirtualWall);
  stop_at("stop_at_wall", protocol::kHazardWall);
  const double ticks_per_metre = 1.0 / profile.geometry.metres_per_tick();
  safety.stall_ms =
      field_or_zero<std::uint16_t>(table, "stall_ms", 1.0, {0, protocol::kMaxStallMs});
  safety.runaway_ticks = field_or_zero<std::uint16_t>(
      table, "runaway_m", ticks_per_metre, {0, protocol::kMaxRunawayTicks});
  safety.over_speed_ticks_per_s =
      field_or_zero<std::uint16_t>(table, "over_speed_m_per_s", ticks_per_metre, {0, UINT16_MAX});
}

/// Contacts that open when they are pressed: their broken wire is a bump.
void read_contacts(const TomlReader& table, protocol::ConfigureWiring& wiring) {
  constexpr unsigned kLeft = 1;
  constexpr unsigned kRight = 2;
  const bool both = table.boolean_or("contacts_normally_closed", false);
  const auto bit_if_closed = [&](std::string_view key, unsigned bit) {
    return table.boolean_or(key, both) ? bit : 0U;
  };
  wiring.contacts_normally_closed =
      static_cast<std::uint8_t>(bit_if_closed("left_contact_normally_closed", kLeft) |
                                bit_if_closed("right_contact_normally_closed", kRight));
}

std::uint8_t standard_stops(const Pins& pins) {
  constexpr auto kCliffs = protocol::kHazardCliffLeft | protocol::kHazardCliffFrontLeft |
                           protocol::kHazardCliffFrontRight | protocol::kHazardCliffRight;
  const bool is_wired = std::ranges::any_of(pins, [](std::uint8_t pin) {
    const unsigned function = pin & ~protocol::kPinActiveHigh;
    return function >= protocol::kPinCliffLeft && function <= protocol::kPinWheelDrop;
  });
  return is_wired ? kCliffs | protocol::kHazardWheelDrop : 0;
}

}  // namespace

void read_sensors(const TomlReader& profile_file, RobotProfile& profile) {
  const Pins pins = profile_file.has("wiring") ? read_pins(profile_file.table("wiring")) : Pins{};
  PutPins put{pins};
  protocol::ConfigurePins::each(profile.configuration.pins, put);
  profile.configuration.safety.hazard_stops = standard_stops(pins);
  const bool has_stepper =
      profile.configuration.pan.kind == static_cast<std::uint8_t>(protocol::PanKind::kStepper);
  for (unsigned phase = 0; has_stepper && phase < 4; ++phase) {
    validate_pin(pins,
                 protocol::kPinStepperPhaseA + phase,
                 profile_file.table("pan"),
                 "kind",
                 std::string("stepper_") + "abcd"[phase]);
  }
  if (profile_file.has("infrared")) {
    read_infrared(profile_file.table("infrared"), pins, profile);
  }
  if (profile_file.has("gyro")) {
    read_gyro(profile_file.table("gyro"), profile);
  }
  if (profile_file.has("battery")) {
    const TomlReader battery = profile_file.table("battery");
    validate_pin(pins, protocol::kPinBattery, battery, "full_scale_v", "battery");
    profile.sensors.battery_full_scale_v = positive(battery, "full_scale_v");
    if (battery.has("return_below_v")) {
      profile.return_below_v = positive(battery, "return_below_v");
    }
    if (battery.has("stop_below_v")) {
      profile.stop_below_v = positive(battery, "stop_below_v");
    }
  }
  if (profile_file.has("scalar")) {
    read_scalar(profile_file.table("scalar"), profile);
  }
  if (profile_file.has("safety")) {
    read_safety(profile_file.table("safety"), profile);
    read_contacts(profile_file.table("safety"), profile.configuration.wiring);
  }
}

}  // namespace echomap::session
