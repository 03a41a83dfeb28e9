// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace echomap::slam {

/// A turn, to the left, and its standard deviation.
struct TurnEstimate {
  double turn_rad = 0.0;
  double stddev_rad = 0.0;
};

/// Mean and deviation of a turn whose log-likelihoods at turns `step_rad` apart are given, an odd
/// number of them, that of no turn in the middle; at least one is finite. The deviation is half a
/// step or more.
TurnEstimate mean_turn(const std::vector<double>& log_likelihoods, double step_rad);

}  // namespace echomap::slam
