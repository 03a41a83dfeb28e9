// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/slam/stop_stand.hpp"

namespace echomap::slam {

/// How two sweeps from one place are compared; ours, chosen in simulated rooms.
struct TurnCalibrationParams {
  /// Turned by less between the first sweep and the last one, they are not of one direction.
  double min_turn_rad = 5.5;
  /// Readings belong to the first or the last sweep while the body is turned by no more than this.
  double same_rad = 0.1;
  /// Odometry is not off by more than this in the whole turn; what is tried, and how finely.
  double max_error_rad = 1.0;
  double step_rad = 0.005;
  /// Readings of the two sweeps are compared where their axes are no farther apart.
  double same_axis_rad = 0.05;
  /// Difference of two ranges of one thing, twice the sonar's noise of 3 cm in square.
  double range_stddev_m = 0.045;
  /// A pair counts so much of a measurement: neighbours in a wide beam hear the same.
  double pair_weight = 0.3;
  /// Fewer readings in a sweep, or a turn that is known less well than this, tell nothing.
  std::size_t min_readings = 20;
  double max_stddev_rad = 0.02;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const TurnCalibrationParams& params);

/// By which share of a turn odometry is off (OdometryCalibration), from a stop whose last sweep is
/// of the direction of its first one, a full turn later: what both have heard tells how far the
/// body has turned indeed, whatever stands there. Empty where the stop has no such sweep, or where
/// it fits at many angles, as in a round room, or best where the search ends.
std::optional<double> turn_share(const std::vector<StopReading>& readings,
                                 const TurnCalibrationParams& params);

}  // namespace echomap::slam
