// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/localization/range_update.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::bench {

/// A step of a simulated robot through the building of global_localization.
struct BuildingStep {
  geometry::Pose2 T_odom_robot;
  geometry::Pose2 T_map_robot;  ///< The truth.
  std::vector<localization::RangeReading> readings;
};

struct BuildingRun {
  double max_range_m = 0.0;
  std::vector<BuildingStep> steps;
};

/// Both throw files::FileError.
mapping::RasterMap read_building(const std::filesystem::path& pgm);
BuildingRun read_building_run(const std::filesystem::path& log);

}  // namespace echomap::bench
