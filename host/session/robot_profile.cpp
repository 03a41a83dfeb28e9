// SPDX-License-Identifier: MIT
#include "host/session/robot_profile.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "host/files/atomic_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"
#include "host/geometry/angle.hpp"
#include "host/mapping/sonar_surfaces.hpp"
#include "host/session/motor_driver_profile.hpp"
#include "host/session/profile_fields.hpp"
#include "host/session/sensor_profile.hpp"
#include "protocol/limits.hpp"

namespace echomap::session {
namespace {

using files::TomlReader;

/// One step of the strategy's scan: a pan that reaches less reads nothing.
constexpr double kMinReachDeg = 6.0;

/// A sonar and a servo that no robot of the profile has: what the firmware holds by itself, so that
/// nothing has to be sent.
constexpr protocol::ConfigureSonar kNoSonar{0, 24000, 40};
constexpr protocol::ConfigurePan kNoPan{0, 0, 1500, 900, 0, -9000, 9000, 300};

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
  profile.geometry.left_wheel_scale = positive_or(table, "left_wheel_scale", 1.0);
  profile.geometry.right_wheel_scale = positive_or(table, "right_wheel_scale", 1.0);
  profile.speed_m_per_s = positive(table, "speed_m_per_s");

  const double ticks_per_metre = 1.0 / profile.geometry.metres_per_tick();
  constexpr Bounds kSpeeds{1, protocol::kMaxTicksPerS};
  constexpr Bounds kAccelerations{1, UINT16_MAX};
  constexpr Bounds kGains{0, protocol::kMaxGain};
  protocol::ConfigureDrive& drive = profile.configuration.drive;
  drive.inversions = inversions(table);
  drive.max_ticks_per_s = field<std::uint16_t>(table, "speed_m_per_s", ticks_per_metre, kSpeeds);
  drive.max_ticks_per_s2 =
      field<std::uint16_t>(table, "acceleration_m_per_s2", ticks_per_metre, kAccelerations);
  drive.feed_forward = field<std::uint16_t>(table, "feed_forward", 1.0, kGains);
  drive.proportional = field<std::uint16_t>(table, "proportional", 1.0, kGains);
  drive.integral = field<std::uint16_t>(table, "integral", 1.0, kGains);
  drive.odometry_period_ms = field<std::uint8_t>(table, "odometry_period_ms", 1.0, {1, UINT8_MAX});
  read_motor_driver(table, profile.configuration.wiring);
}

void read_odometry(const TomlReader& table, RobotProfile& profile) {
  std::vector<localization::MeasuredDistance> distances;
  for (const auto& [odometry_m, true_m] : table.points("measured_m")) {
    distances.push_back({odometry_m, true_m});
  }
  const auto correction = localization::fit_correction(distances);
  if (!correction || !(correction->slope > 0.0)) {
    table.fail("measured_m",
               "'measured_m' must hold pairs [by odometry, by tape] of two different drives or "
               "more, in metres");
  }
  profile.distance_correction = *correction;
}

void read_sonar(const TomlReader& table, RobotProfile& profile) {
  profile.geometry.sonar_x_m = table.number("x_m");
  profile.geometry.sonar_y_m = table.number("y_m");
  profile.range_scale = positive_or(table, "range_scale", 1.0);
  profile.range.speed_of_sound_m_s *= profile.range_scale;
  profile.range.min_range_m = positive(table, "min_range_m");
  profile.range.max_range_m = positive(table, "max_range_m");
  if (profile.range.max_range_m <= profile.range.min_range_m) {
    table.fail("max_range_m", "'max_range_m' must be greater than 'min_range_m'");
  }
  profile.beam_half_angle_rad = geometry::radians(positive(table, "beam_half_angle_deg"));
  if (profile.beam_half_angle_rad > mapping::kMaxBeamHalfAngleRad) {
    table.fail("beam_half_angle_deg",
               fmt::format("'beam_half_angle_deg' must be at most {:g}: a wider one tells no walls",
                           geometry::degrees(mapping::kMaxBeamHalfAngleRad)));
  }

  const double microseconds_per_metre = 2.0e6 / profile.range.speed_of_sound_m_s;
  constexpr Bounds kFlights{1, protocol::kNoSonar - 1};
  profile.configuration.sonar.max_echo_us =
      field<std::uint16_t>(table, "max_range_m", microseconds_per_metre, kFlights);
  profile.configuration.sonar.ping_gap_ms = field<std::uint8_t>(table, "ping_gap_ms");
}

/// A servo makes one pulse for each angle, and these must be among those that the board makes.
void read_servo(const TomlReader& table, protocol::ConfigurePan& pan) {
  constexpr Bounds kPulses{protocol::kMinServoPulseUs, protocol::kMaxServoPulseUs};
  pan.kind = static_cast<std::uint8_t>(protocol::PanKind::kServo);
  pan.centre_us = field<std::uint16_t>(table, "centre_us", 1.0, kPulses);
  pan.us_per_90deg = field<std::int16_t>(table, "us_per_90deg");
  for (const std::string_view end : {"min_deg", "max_deg"}) {
    const double pulse_us = pan.centre_us + pan.us_per_90deg * table.number(end) / 90.0;
    if (pulse_us < kPulses.least || pulse_us > kPulses.most) {
      table.fail(
          end,
          fmt::format("'{}' needs a servo pulse of {:.0f} us, and the board makes {:g} to {:g}",
                      end,
                      pulse_us,
                      kPulses.least,
                      kPulses.most));
    }
  }
}

void read_stepper(const TomlReader& table, protocol::ConfigurePan& pan) {
  constexpr double kMaxSteps = protocol::kMaxStepsPerTurn;
  pan.kind = static_cast<std::uint8_t>(protocol::PanKind::kStepper);
  pan.steps_per_turn =
      field<std::int16_t>(table, "half_steps_per_turn", 1.0, {-kMaxSteps, kMaxSteps});
  if (pan.steps_per_turn == 0) {
    table.fail("half_steps_per_turn", "'half_steps_per_turn' must not be 0");
  }
}

void read_pan(const TomlReader& table, RobotProfile& profile) {
  constexpr double kCentidegrees = 100.0;
  constexpr Bounds kAngles{-protocol::kMaxPanCdeg, protocol::kMaxPanCdeg};
  protocol::ConfigurePan& pan = profile.configuration.pan;
  pan.min_cdeg = field<std::int32_t>(table, "min_deg", kCentidegrees, kAngles);
  pan.max_cdeg = field<std::int32_t>(table, "max_deg", kCentidegrees, kAngles);
  pan.deg_per_s = field<std::uint16_t>(table, "speed_deg_per_s", 1.0, {1, UINT16_MAX});
  profile.settle_s =
      1e-3 * field<std::uint16_t>(table, "settle_ms", 1.0, {0, protocol::kMaxSettleMs});

  const double reach_deg = std::min(-table.number("min_deg"), table.number("max_deg"));
  if (reach_deg < kMinReachDeg) {
    table.fail(
        "min_deg",
        fmt::format(
            "the pan must reach at least {:g} degrees to both sides: 'min_deg' < 0 < 'max_deg'",
            kMinReachDeg));
  }
  profile.pan_limit_rad = geometry::radians(reach_deg);
  const std::string kind = table.text_or("kind", "servo");
  if (kind == "servo") {
    read_servo(table, pan);
  } else if (kind == "stepper") {
    read_stepper(table, pan);
  } else {
    table.fail("kind", "'kind' must be \"servo\" or \"stepper\"");
  }
}

std::string text_of(const std::filesystem::path& file) {
  try {
    return files::read_text_file(file);
  } catch (const files::FileError& error) {
    throw files::ConfigError(error.what());
  }
}

}  // namespace

std::uint16_t RobotProfile::ticks_per_s() const { return configuration.drive.max_ticks_per_s; }

RobotProfile load_robot_profile(const std::string& name_or_file) {
  const auto path = files::bundled_file(name_or_file, "host/profiles", "robot profile");
  return parse_robot_profile(text_of(path), path.string());
}

RobotProfile parse_robot_profile(const std::string& text, const std::string& file) {
  RobotProfile profile;
  profile.toml = text;
  const auto toml = TomlReader::parse(profile.toml, file);
  profile.name = toml.text("name");
  read_drive(toml.table("drive"), profile);
  profile.body_radius_m = positive(toml.table("body"), "radius_m");
  profile.configuration.sonar = kNoSonar;
  profile.configuration.pan = kNoPan;
  profile.has_sonar = toml.has("sonar");
  if (profile.has_sonar) {
    read_sonar(toml.table("sonar"), profile);
    read_pan(toml.table("pan"), profile);
  }
  if (toml.has("odometry")) {
    read_odometry(toml.table("odometry"), profile);
  }
  read_sensors(toml, profile);
  toml.reject_unknown_keys();
  return profile;
}

double sure_range_m(const RobotProfile& profile) {
  constexpr double kMarginM = 0.2;
  return profile.range.max_range_m - kMarginM;
}

}  // namespace echomap::session
