// SPDX-License-Identifier: MIT
#pragma once

#include "host/diagnosis/robot_errors.hpp"
#include "host/diagnosis/stand_log.hpp"

namespace echomap::diagnosis {

/// When two stands, or a stand and a rolling ping, have heard one surface; ours, chosen in
/// simulated rooms.
struct StandAgreementParams {
  /// Of a wall's bearing, of its depth, and of the place of a post or corner; and what odometry
  /// adds to them on its way from one stand to the other, in proportion to the way, of the bearing
  /// to its root.
  double bearing_stddev_rad = 0.04;
  double depth_stddev_m = 0.018;
  double point_stddev_m = 0.05;
  double bearing_drift_rad_per_sqrt_m = 0.006;
  double drift_m_per_m = 0.01;
  /// Walls are heard from places so far apart at most.
  double max_apart_m = 2.5;
  /// Two surfaces that agree entirely speak so many times for a robot of these errors.
  double weight = 20.0;
  /// A surface of fewer readings counts less.
  double full_readings = 8.0;
  /// A ping's range, in addition to the surface's depth; how far off its axis (14 degrees) it hears
  /// a surface; and how far the robot has rolled between it and a stand with that surface at most.
  double ping_stddev_m = 0.03;
  double min_ping_cosine = 0.97;
  double max_ping_travel_m = 1.5;
  /// Pings that hear one surface share its errors, and so count less than a surface.
  double ping_weight = 0.25;
};

/// How well what a robot of these errors has heard agrees: a log-likelihood ratio against stands
/// and pings that have nothing to do with each other. A surface counts by the one of the stands
/// before that it agrees with best, a rolling ping by that of all stands, on the same piece of the
/// way.
double log_agreement(const StandLog& log,
                     const RobotErrors& errors,
                     const StandAgreementParams& params = {});

}  // namespace echomap::diagnosis
