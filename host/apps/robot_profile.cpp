// SPDX-License-Identifier: MIT
#include "host/apps/robot_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::apps {
namespace {

using files::TomlReader;

double positive(const TomlReader& table, std::string_view key) {
  const double value = table.number(key);
  if (value <= 0.0) {
    table.fail(key, "'" + std::string(key) + "' must be greater than zero");
  }
  return value;
}

/// The nearest whole number that a field of the wire can hold.
template <class T>
T as_field(const TomlReader& table, std::string_view key, double value) {
  const double rounded = std::round(value);
  if (rounded < std::numeric_limits<T>::min() || rounded > std::numeric_limits<T>::max()) {
    table.fail(key, "'" + std::string(key) + "' is larger than the board can take");
  }
  return static_cast<T>(rounded);
}

template <class T>
T field(const TomlReader& table, std::string_view key, double scale = 1.0) {
  return as_field<T>(table, key, table.number(key) * scale);
}

std::uint8_t inversions(const TomlReader& table) {
  std::uint8_t bits = 0;
  const auto add = [&](std::string_view key, std::uint8_t bit) {
    bits = static_cast<std::uint8_t>(bits | (table.boolean_or(key, false) ? bit : 0));
  };
  add("invert_left_motor", protocol::kInvertLeftMotor);
  add("invert_right_motor", protocol::kInvertRightMotor);
  add("invert_left_encoder", protocol::kInvertLeftEncoder);
  add("invert_right_encoder", protocol::kInvertRightEncoder);
  return bits;
}

void read_drive(const TomlReader& table, RobotProfile& profile) {
  profile.geometry.wheel_diameter_m = positive(table, "wheel_diameter_m");
  profile.geometry.track_m = positive(table, "track_m");
  profile.geometry.counts_per_turn = positive(table, "counts_per_turn");
  profile.speed_m_per_s = positive(table, "speed_m_per_s");

  const double ticks_per_metre = 1.0 / profile.geometry.metres_per_tick();
  protocol::ConfigureDrive& drive = profile.drive;
  drive.inversions = inversions(table);
  drive.max_ticks_per_s = field<std::uint16_t>(table, "speed_m_per_s", ticks_per_metre);
  drive.max_ticks_per_s2 = field<std::uint16_t>(table, "acceleration_m_per_s2", ticks_per_metre);
  drive.feed_forward = field<std::uint16_t>(table, "feed_forward");
  drive.proportional = field<std::uint16_t>(table, "proportional");
  drive.integral = field<std::uint16_t>(table, "integral");
  drive.odometry_period_ms = field<std::uint8_t>(table, "odometry_period_ms");
}

void read_sonar(const TomlReader& table, RobotProfile& profile) {
  profile.geometry.sonar_x_m = table.number("x_m");
  profile.geometry.sonar_y_m = table.number("y_m");
  profile.range.min_range_m = positive(table, "min_range_m");
  profile.range.max_range_m = positive(table, "max_range_m");
  if (profile.range.max_range_m <= profile.range.min_range_m) {
    table.fail("max_range_m", "'max_range_m' must be greater than 'min_range_m'");
  }
  profile.beam_half_angle_rad = geometry::radians(positive(table, "beam_half_angle_deg"));

  const double microseconds_per_metre = 2.0e6 / profile.range.speed_of_sound_m_s;
  const double flight_us = profile.range.max_range_m * microseconds_per_metre;
  profile.sonar.max_echo_us = as_field<std::uint16_t>(table, "max_range_m", flight_us);
  profile.sonar.ping_gap_ms = field<std::uint8_t>(table, "ping_gap_ms");
}

void read_pan(const TomlReader& table, RobotProfile& profile) {
  constexpr double kCentidegrees = 100.0;
  protocol::ConfigureSonar& sonar = profile.sonar;
  sonar.pan_centre_us = field<std::uint16_t>(table, "centre_us");
  sonar.pan_us_per_90deg = field<std::int16_t>(table, "us_per_90deg");
  sonar.pan_min_cdeg = field<std::int16_t>(table, "min_deg", kCentidegrees);
  sonar.pan_max_cdeg = field<std::int16_t>(table, "max_deg", kCentidegrees);
  sonar.pan_deg_per_s = field<std::uint16_t>(table, "speed_deg_per_s");
  profile.settle_s = 1e-3 * table.number("settle_ms");

  const double reach_deg = std::min(-table.number("min_deg"), table.number("max_deg"));
  if (reach_deg <= 0.0) {
    table.fail("min_deg", "the pan must reach to both sides: 'min_deg' < 0 < 'max_deg'");
  }
  profile.pan_limit_rad = geometry::radians(reach_deg);
}

}  // namespace

std::uint16_t RobotProfile::ticks_per_s() const { return drive.max_ticks_per_s; }

RobotProfile load_robot_profile(const std::string& name_or_file) {
  const auto toml =
      TomlReader::load(files::bundled_file(name_or_file, "host/profiles", "robot profile"));
  RobotProfile profile;
  profile.name = toml.text("name");
  read_drive(toml.table("drive"), profile);
  profile.body_radius_m = positive(toml.table("body"), "radius_m");
  read_sonar(toml.table("sonar"), profile);
  read_pan(toml.table("pan"), profile);
  toml.reject_unknown_keys();
  return profile;
}

}  // namespace echomap::apps
