// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hil_mock/world/motor_driver.hpp"
#include "hil_mock/world/part_params.hpp"
#include "hil_mock/world/wiring.hpp"

namespace echomap::world {

/// Wheels, motors and encoders of a simulated robot. The defaults are those of
/// hil_mock/robots/uno_2wd.toml, which names the source of each.
struct DriveParams {
  DriverChip driver = DriverChip::kPhaseEnable;
  /// Resistors of 10 kOhm to ground at the enables of a driver whose inputs float high.
  bool pull_downs = true;
  double wheel_diameter_m = 0.065;
  /// Between the wheels' points of contact.
  double track_m = 0.140;
  /// Edges of both encoder channels (x4) in one turn of a wheel.
  double counts_per_turn = 1496.0;
  /// Speed over ground at full duty.
  double no_load_speed_m_per_s = 0.45;
  /// Of the first-order answer of a wheel's speed to its duty.
  double time_constant_s = 0.08;
  /// Of a wheel whose driver has let go of the motor, beside the dry friction of its dead zone.
  double coast_time_constant_s = 0.24;
  /// Duty, 0 .. 1, below which a motor stands still; 0 of a servo, which has its own.
  double dead_zone_duty = 0.12;
  /// Standard deviations over runs, relative: both wheels' diameter in common, one wheel against
  /// the other, the track, one motor's speed at a given duty.
  double wheel_diameter_stddev = 0.005;
  double wheel_mismatch_stddev = 0.0003;
  double track_stddev = 0.005;
  double motor_gain_stddev = 0.03;
  /// Random walk of each wheel's travel over ground: standard deviation after one metre.
  double slip_m_per_sqrt_m = 0.001;
};

/// The robot's body, a disc about the middle of the axle, and its two front bumpers.
struct BodyParams {
  double radius_m = 0.09;
  bool has_bumpers = true;
  bool contacts_normally_closed = false;  ///< Its contacts open where they touch something.
  /// A bumper is pressed when a wall comes nearer to the disc than this.
  double bumper_travel_m = 0.002;
  /// Each bumper reaches from `bumper_overlap_rad` beyond straight ahead to `bumper_end_rad` on
  /// its own side.
  double bumper_overlap_rad = 0.17;
  double bumper_end_rad = 1.22;
};

/// The pan servo: what its pulses mean and how fast it follows.
struct PanParams {
  double centre_us = 1500.0;
  /// Change of the pulse for a quarter turn to the left.
  double us_per_90deg = 900.0;
  double slew_rad_per_s = 5.2;
  /// Mechanical stop on either side.
  double limit_rad = 1.571;
};

/// The sonar: place, beam, range and what surfaces do to its sound.
struct SonarParams {
  /// Pan axis and transducer in the robot frame; the transducer sits on the axis.
  double mount_x_m = 0.03;
  double mount_y_m = 0.0;
  /// Angle off the axis at which a thin pole is seen every second time.
  double beam_half_angle_rad = 0.227;
  double min_range_m = 0.04;
  double max_range_m = 4.0;
  /// Standard deviation of a reading.
  double range_noise_m = 0.03;
  /// Incidence, ray against the wall's normal, at which half of the echoes are lost. With the
  /// beam's width this loses a smooth wall between 25 and 30 degrees off the axis.
  double smooth_limit_rad = 0.262;
  double rough_limit_rad = 0.873;
  /// Chance that a right-angled niche, or a right-angled edge, answers on the axis.
  double niche_strength = 0.9;
  double edge_strength = 0.4;
  /// Chance that sound which a smooth wall has thrown aside comes back from a second one.
  double ghost_strength = 0.25;
  double speed_of_sound_m_per_s = 343.2;
};

/// A whole simulated robot.
struct RobotParams {
  std::string name = "uno_2wd";
  DriveParams drive;
  BodyParams body;
  PanParams pan;
  bool has_sonar = true;
  SonarParams sonar;
  PartParams parts;
  Wiring wiring;
};

}  // namespace echomap::world
