// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "host/localization/odometry_correction.hpp"
#include "host/sensors/observation_converter.hpp"
#include "host/sensors/robot_geometry.hpp"
#include "protocol/configuration.hpp"

namespace echomap::session {

/// Everything the host knows of one kind of robot, from its profile's TOML. What the board needs is
/// sent at connect, so a number is never changed by flashing.
struct RobotProfile {
  std::string name;
  std::string toml;  ///< Text of its file.
  sensors::RobotGeometry geometry;
  sensors::SonarRangeParams range;
  double range_scale = 1.0;  ///< In the speed of sound of `range`.
  double speed_m_per_s = 0.0;
  double body_radius_m = 0.0;
  double beam_half_angle_rad = 0.0;
  double pan_limit_rad = 0.0;  ///< The pan reaches from minus this to plus this.
  double settle_s = 0.0;       ///< Wait after a pan step, once the servo has arrived.
  bool has_sonar = false;      ///< Else sonar and pan above mean nothing.
  sensors::SensorParams sensors;
  /// Of the battery: go home below the one, stop below the other; empty where the profile gives
  /// none.
  std::optional<double> return_below_v;
  std::optional<double> stop_below_v;
  /// Of the way by odometry, from drives that were measured.
  localization::DistanceCorrection distance_correction;
  /// What the board must hold, with command_ids of 0.
  protocol::Configuration configuration{};

  /// Counts per second of a wheel that rolls at `speed_m_per_s`.
  std::uint16_t ticks_per_s() const;
};

/// `name_or_file` is the name of a bundled profile ("uno_2wd") or a path that ends in .toml. Throws
/// files::ConfigError.
RobotProfile load_robot_profile(const std::string& name_or_file);
/// The profile that a file's text holds; `file` stands for it in messages. Throws
/// files::ConfigError.
RobotProfile parse_robot_profile(const std::string& text, const std::string& file);

/// Up to there a wall that the sonar faces answers for sure, whatever the noise, metres.
double sure_range_m(const RobotProfile& profile);

}  // namespace echomap::session
