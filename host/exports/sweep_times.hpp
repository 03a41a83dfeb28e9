// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/exports/sonar_sweeps.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// A sweep with the time at which it was complete.
struct TimedSweep {
  SonarSweep sweep;
  std::size_t pose = 0;  ///< Index of the pose of the trajectory at that time.
};

/// The sweeps of all stops, in their order, which is that of their times. The readings of a
/// snapshot have no stamps: a sweep of many readings was made when the robot stayed where it was
/// made, and sweeps of one place share the stay by the number of their readings; short sweeps,
/// which a robot makes while it turns, lie evenly in between. Empty without a trajectory.
std::vector<TimedSweep> timed_sweeps(const pipeline::Snapshot& snapshot);

}  // namespace echomap::exports
