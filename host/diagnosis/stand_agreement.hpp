// SPDX-License-Identifier: MIT
#pragma once

#include "host/diagnosis/robot_errors.hpp"
#include "host/diagnosis/stand_log.hpp"

namespace echomap::diagnosis {

/// When two stands have heard one surface; ours, chosen in simulated rooms.
struct StandAgreementParams {
  /// Of a wall's bearing, of its depth, and of the place of a post or corner; and what odometry
  /// adds to them on its way from one stand to the other, in proportion to the way, of the bearing
  /// to its root.
  double bearing_stddev_rad = 0.05;
  double depth_stddev_m = 0.025;
  double point_stddev_m = 0.05;
  double bearing_drift_rad_per_sqrt_m = 0.006;
  double drift_m_per_m = 0.01;
  /// Walls are heard from places so far apart at most.
  double max_apart_m = 2.5;
  /// Two surfaces that agree entirely speak so many times for a robot of these errors.
  double weight = 20.0;
  /// A surface of fewer readings counts less.
  double full_readings = 8.0;
};

/// How well what a robot of these errors has heard at its stands agrees: a log-likelihood ratio
/// against stands that have nothing to do with each other, in which each surface counts by the one
/// of the stands before, on the same piece of the way, that it agrees with best.
double log_agreement(const StandLog& log,
                     const RobotErrors& errors,
                     const StandAgreementParams& params = {});

}  // namespace echomap::diagnosis
