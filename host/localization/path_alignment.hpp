// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/localization/observation_model.hpp"
#include "host/localization/stop_scan.hpp"

namespace echomap::localization {

/// Where a robot was at each of its scans, T_map_robot, the newest first.
using ScanPath = std::vector<geometry::Pose2>;

/// Path that the odometry of the scans, the newest first, tells of a robot that is at a pose.
ScanPath path_by_odometry(std::span<const StopScan> scans, const geometry::Pose2& T_map_robot);

/// Moves each pose of the paths to where its scan fits the map best, as far as odometry may err
/// from one scan to the next: towards the maximum a posteriori path, one pose after the other, of
/// which all others are held (iterated conditional modes, Besag 1986). All paths have a pose for
/// each of the scans, the newest first. So drift of odometry and distortion of the map hardly count
/// where places are compared. A pose moves by at most 0.2 m along x and y, and 0.2 rad.
void align_paths(std::span<const StopScan> scans,
                 ObservationModel& model,
                 std::span<ScanPath> paths);

}  // namespace echomap::localization
