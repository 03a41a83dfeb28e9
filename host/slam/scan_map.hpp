// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/ray_insertion.hpp"
#include "host/mapping/sonar_cone_mapper.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {

/// How scans of known poses become a map.
struct ScanMapParams {
  /// For cones; their half angle and reach are those of the scans.
  mapping::SonarConeMapperParams cones;
  /// For thin beams.
  mapping::RayInsertionParams rays;
};

/// The map of scans of one sensor: of cones as SonarConeMapper understands them together, of thin
/// beams ray by ray. Beams are cones if those of the first scan are. A pose of the robot for each
/// scan.
mapping::OccupancyGrid map_of_scans(const std::vector<geometry::Pose2>& T_map_robots,
                                    const std::vector<sensors::RangeScan>& scans,
                                    const ScanMapParams& params);

}  // namespace echomap::slam
