// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace echomap::bench {

/// Processor time of one step of EKF-SLAM in a map of so many landmarks: one motion, ten sightings
/// of unknown landmarks associated jointly, one update of all ten.
struct EkfSlamStepCost {
  double move_ms = 0.0;
  double associate_ms = 0.0;
  double update_ms = 0.0;
};

EkfSlamStepCost ekf_slam_step_cost(std::size_t landmarks, int steps);

}  // namespace echomap::bench
