// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "host/geometry/pose2.hpp"

namespace echomap::exports {

/// poses.csv, the second of the two matrices of Singh and Bedi 2013: a header line, then one pose a
/// line as `x_m,y_m,heading_rad` (map frame), in the order in which the robot took them. Numbers
/// are the shortest that read back the same. Throws files::FileError.
void write_poses_csv(const std::filesystem::path& path, const std::vector<geometry::Pose2>& poses);

}  // namespace echomap::exports
