// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads the map of one of our own run directories (or, of that, its poses.csv): poses.csv, a pose
/// of a stop a line as `x_m,y_m,heading_rad`, and points.csv, an echo a line as
/// `x_m,y_m,pose_index`, in the order of their poses. Each pose is an OdometryPose, which the
/// robot's own map has corrected, and the same as a GivenPose; where it has echoes, a RangeScan of
/// them with thin beams from the middle of the robot: the run directory says where the echoes lie
/// and not how wide the cones were. No stamps. Throws files::FileError.
std::unique_ptr<LogReader> open_run_directory_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
