// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "host/datasets/log_record.hpp"
#include "host/geometry/pose2.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/nearest_points.hpp"

namespace echomap::bench {

/// A laser scan with its corrected pose.
struct PosedScan {
  geometry::Pose2 T_map_laser;
  sensors::RangeScan scan;
};

/// All scans of a CARMEN log with given poses. Throws files::FileError.
std::vector<PosedScan> read_posed_scans(const std::filesystem::path& log);

/// How a map agrees with the laser's.
struct LaserAgreement {
  /// Intersection over union of the free cells.
  double free_iou = 0.0;
  /// Root mean square distance from an occupied cell to the laser map's nearest, metres.
  double wall_rmse_m = 0.0;
  /// Share of the laser map's occupied cells within the sonar's reach that have an occupied cell
  /// within 10 cm.
  double wall_recall = 0.0;
};

/// The laser's own map: thin rays of the given poses, 5 cm cells.
class LaserTruth {
 public:
  LaserTruth(const std::vector<PosedScan>& scans, double sonar_range_m);

  /// Throws std::invalid_argument for a map without an occupied cell.
  LaserAgreement score(const mapping::OccupancyGrid& map) const;
  /// The wall_recall of a map with these occupied points.
  double wall_recall(const std::vector<Eigen::Vector2d>& occupied_m) const;

 private:
  mapping::OccupancyGrid grid_;
  std::vector<Eigen::Vector2d> reachable_walls_m_;
  tests::NearestPoints walls_;
};

}  // namespace echomap::bench
