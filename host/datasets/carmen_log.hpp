// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads a CARMEN log:
///
/// - `ODOM x y theta tv rv accel t host t`: an OdometryPose.
/// - `FLASER n r1 .. rn x y theta odom_x odom_y odom_theta t host t`: an OdometryPose (the second
///   three), a GivenPose (the first three) and a RangeScan over 180 degrees from right to left.
///   Corrected logs repeat the corrected pose in both; uncorrected ones the odometry.
/// - `ROBOTLASER1 type start field step max accuracy remission n r1 .. rn m s1 .. sm`, pose of the
///   laser, pose of the robot, five numbers, `t host t`: the same, with the pose of the robot for
///   both, as the file has no other.
///
/// Metres and radians. A FLASER range of 50 m or more is no return (50, 51.1 and 81.9 in the public
/// logs), one of ROBOTLASER1 from its own `max` on; zero is none either. Other lines are skipped,
/// comments among them, which hold the word FLASER too. Throws files::FileError.
std::unique_ptr<LogReader> open_carmen_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
