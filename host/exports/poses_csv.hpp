// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/point_cloud_map.hpp"

namespace echomap::exports {

/// poses.csv, the second of the two matrices of Singh and Bedi 2013: a header line, then one pose a
/// line as `x_m,y_m,heading_rad` (map frame), in the order in which the robot took them. Numbers
/// are the shortest that read back the same. Throws files::FileError.
void write_poses_csv(const std::filesystem::path& path, const std::vector<geometry::Pose2>& poses);

/// Throws files::FileError whose text begins `file:line: ` where the file is not as above.
std::vector<geometry::Pose2> read_poses_csv(const std::filesystem::path& path);

/// The map that a run directory's points.csv and poses.csv hold. Throws files::FileError, also
/// where a point names a pose that is not there.
mapping::PointCloudMap read_point_cloud_map(const std::filesystem::path& run_directory);

}  // namespace echomap::exports
