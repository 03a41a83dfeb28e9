// SPDX-License-Identifier: MIT
#include "hil_mock/world/robot_file.hpp"

#include <stdexcept>

#include "hil_mock/world/part_file.hpp"
#include "hil_mock/world/toml_values.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::world {
namespace {

/// Assumed: nobody has measured how a gear motor rolls out.
constexpr double kUsualCoastFactor = 3.0;

DriverChip read_driver(const files::TomlReader& table) {
  if (!table.has("driver")) {
    return DriverChip::kPhaseEnable;
  }
  try {
    return driver_named(table.text("driver"));
  } catch (const std::invalid_argument& unknown) {
    table.fail("driver", unknown.what());
  }
}

DriveParams read_drive(const files::TomlReader& table) {
  DriveParams drive;
  drive.driver = read_driver(table);
  drive.pull_downs = table.boolean_or("pull_downs", drive.pull_downs);
  drive.wheel_diameter_m = positive(table, "wheel_diameter_m");
  drive.track_m = positive(table, "track_m");
  drive.counts_per_turn = positive(table, "counts_per_turn");
  drive.no_load_speed_m_per_s = positive(table, "no_load_speed_m_per_s");
  drive.time_constant_s = positive(table, "time_constant_s");
  drive.coast_time_constant_s = table.has("coast_time_constant_s")
                                    ? positive(table, "coast_time_constant_s")
                                    : kUsualCoastFactor * drive.time_constant_s;
  const double usual_dead_zone = drive.driver == DriverChip::kServo ? 0.0 : drive.dead_zone_duty;
  drive.dead_zone_duty = within(table, "dead_zone_duty", usual_dead_zone, 0.9);
  drive.wheel_diameter_stddev =
      within(table, "wheel_diameter_stddev", drive.wheel_diameter_stddev, 0.1);
  drive.wheel_mismatch_stddev =
      within(table, "wheel_mismatch_stddev", drive.wheel_mismatch_stddev, 0.1);
  drive.track_stddev = within(table, "track_stddev", drive.track_stddev, 0.1);
  drive.motor_gain_stddev = within(table, "motor_gain_stddev", drive.motor_gain_stddev, 0.2);
  drive.slip_m_per_sqrt_m = within(table, "slip_m_per_sqrt_m", drive.slip_m_per_sqrt_m, 0.1);
  return drive;
}

BodyParams read_body(const files::TomlReader& table) {
  BodyParams body;
  body.radius_m = positive(table, "radius_m");
  body.has_bumpers = table.boolean_or("bumpers", true);
  body.contacts_normally_closed = table.boolean_or("contacts_normally_closed", false);
  body.bumper_travel_m = within(table, "bumper_travel_m", body.bumper_travel_m, 0.05);
  body.bumper_overlap_rad = angle(table, "bumper_overlap_deg", body.bumper_overlap_rad);
  body.bumper_end_rad = angle(table, "bumper_end_deg", body.bumper_end_rad);
  return body;
}

PanParams read_pan(const files::TomlReader& table) {
  PanParams pan;
  pan.centre_us = positive(table, "centre_us");
  pan.us_per_90deg = table.number("us_per_90deg");
  if (pan.us_per_90deg == 0.0) {
    table.fail("us_per_90deg", "it must not be 0");
  }
  pan.slew_rad_per_s = geometry::radians(positive(table, "slew_deg_per_s"));
  pan.limit_rad = geometry::radians(positive(table, "limit_deg"));
  return pan;
}

SonarParams read_sonar(const files::TomlReader& table) {
  SonarParams sonar;
  sonar.mount_x_m = table.number("mount_x_m");
  sonar.mount_y_m = table.number("mount_y_m");
  sonar.beam_half_angle_rad = geometry::radians(positive(table, "beam_half_angle_deg"));
  if (sonar.beam_half_angle_rad >= geometry::radians(45.0)) {
    table.fail("beam_half_angle_deg", "it must be below 45");
  }
  sonar.min_range_m = positive(table, "min_range_m");
  sonar.max_range_m = positive(table, "max_range_m");
  if (sonar.max_range_m <= sonar.min_range_m) {
    table.fail("max_range_m", "it must be more than min_range_m");
  }
  sonar.range_noise_m = within(table, "range_noise_m", sonar.range_noise_m, 1.0);
  sonar.smooth_limit_rad = angle(table, "smooth_limit_deg", sonar.smooth_limit_rad);
  sonar.rough_limit_rad = angle(table, "rough_limit_deg", sonar.rough_limit_rad);
  sonar.niche_strength = within(table, "niche_strength", sonar.niche_strength, 1.0);
  sonar.edge_strength = within(table, "edge_strength", sonar.edge_strength, 1.0);
  sonar.ghost_strength = within(table, "ghost_strength", sonar.ghost_strength, 1.0);
  return sonar;
}

}  // namespace

RobotParams read_robot(const files::TomlReader& file) {
  RobotParams robot;
  robot.name = file.text("name");
  robot.drive = read_drive(file.table("drive"));
  robot.body = read_body(file.table("body"));
  robot.parts = read_parts(file);
  if (file.has("pan")) {
    robot.pan = read_pan(file.table("pan"));
    if (robot.parts.stepper) {
      file.fail("pan", "a robot has one pan drive: [pan] or [stepper]");
    }
  }
  robot.has_sonar = file.has("sonar");
  if (robot.has_sonar) {
    robot.sonar = read_sonar(file.table("sonar"));
  }
  robot.wiring = read_wiring(file, robot.parts);
  file.reject_unknown_keys();
  return robot;
}

}  // namespace echomap::world
