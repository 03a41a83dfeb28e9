// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// What a CARMEN log says of the sonar.
struct CarmenLogParams {
  /// What a reading without echo has as its range, metres; an echo that is farther raises it for
  /// the whole log. 4 m is the range of the HC-SR04.
  double max_range_m = 4.0;
  /// Standard deviation of a range, metres: the accuracy of a line of ranges.
  double range_stddev_m = 0.03;
};

/// run.carmen: a run as a log of CARMEN's logger (Montemerlo, Roy and Thrun 2003), in metres,
/// radians and seconds of the robot's clock, in the order of time:
///
/// - `PARAM robot_front_laser_max`, `laser_front_laser_resolution` (degrees) and
///   `robot_frontlaser_offset` (0: every line has the pose of its sensor), which readers look for.
/// - `ODOM x y theta tv rv accel t host t`: each pose of the trajectory as SLAM has it at the end,
///   in the map frame; a corrected log, as those with the poses of a scan matcher are.
/// - `ROBOTLASER1` for every sweep of a stop (SonarSweep), when it is complete (timed_sweeps).
/// CARMEN's own
///   line for sonars, SONAR, is one of a fixed ring, and its readers are few: datasets::carmen_log,
///   MRPT's carmen2rawlog and GMapping read lasers. FLASER has 180 degrees by definition; this line
///   has a field of view of its own. The sensor looks to the middle of the sweep, as readers want
///   who pass over the first bearing. A reading without echo has the maximum range, one that the
///   sonar did not answer 0. The type of the sensor is 99, unknown.
///
/// Throws files::FileError, and std::invalid_argument for a parameter that is out of range.
void write_carmen_log(const std::filesystem::path& path,
                      const pipeline::Snapshot& snapshot,
                      const CarmenLogParams& params = {});

}  // namespace echomap::exports
