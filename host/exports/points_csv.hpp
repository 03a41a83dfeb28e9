// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "host/mapping/point_cloud_map.hpp"

namespace echomap::exports {

/// points.csv, the first of the two matrices of Singh and Bedi 2013: a header line, then one echo a
/// line as `x_m,y_m,pose_index` (map frame). Numbers are the shortest that read back the same.
/// Throws files::FileError.
void write_points_csv(const std::filesystem::path& path,
                      const std::vector<mapping::MapPoint>& points);

}  // namespace echomap::exports
