// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "host/datasets/log_record.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::papers {

/// What a robot with a laser has measured, and where it truly was.
struct LaserDrive {
  /// A scan, then an increment of odometry before each further scan, as in the Edmonton log.
  std::vector<datasets::LogRecord> records;
  std::vector<geometry::Pose2> T_start_scans;  ///< True poses of the scans, from the first one.
};

/// The bundled world `hall`, entered along its x axis.
world::FloorPlan laser_hall();

/// Drives three rounds through `laser_hall`: odometry with the errors of a simulated Create, whose
/// tracks and wheels differ from run to run, and a laser at its centre, 180 beams from -90 degrees
/// on with 2 cm of noise.
LaserDrive drive_hall(const world::FloorPlan& hall, std::uint32_t seed);

}  // namespace echomap::papers
