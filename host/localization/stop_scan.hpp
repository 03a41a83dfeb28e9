// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/localization/observation_model.hpp"

namespace echomap::localization {

/// What a robot has heard at a stop, and since the one before on its way there. Readings are
/// relative to the robot at the stop.
struct StopScan {
  geometry::Pose2 T_odom_robot;
  std::vector<RangeReading> readings;
  std::vector<RangeReading> on_the_way;
};

/// All readings of the scan, those of the way, too.
std::vector<RangeReading> all_readings(const StopScan& scan);

/// The readings of all scans, the newest first, rigidly joined by odometry: relative to the robot
/// at the newest.
std::vector<RangeReading> joined(std::span<const StopScan> scans);

/// What was heard near each other: by sectors of the scan's turn, so many of them, and by as many
/// pieces of the way. Those of fewer than two readings are left out.
std::vector<std::vector<RangeReading>> sectors_of(const StopScan& scan, std::size_t sectors);

}  // namespace echomap::localization
