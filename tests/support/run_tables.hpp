// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/point_cloud_map.hpp"

namespace echomap::tests {

/// Reads points.csv. Throws files::FileError whose text begins `file:line: ` where the file is
/// none.
std::vector<mapping::MapPoint> read_points_csv(const std::filesystem::path& path);

/// Reads poses.csv. Throws files::FileError whose text begins `file:line: ` where the file is none.
std::vector<geometry::Pose2> read_poses_csv(const std::filesystem::path& path);

/// The map that a run directory's points.csv and poses.csv hold. Throws files::FileError, also
/// where a point names a pose that is not there.
mapping::PointCloudMap read_point_cloud_map(const std::filesystem::path& run_directory);

/// What occupancy_grid.csv holds.
struct ProbabilityTable {
  double resolution_m = 0.0;
  /// The lower left corner in the map frame.
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
  int columns = 0;
  int rows = 0;
  /// Of being occupied, row by row from the lowest, each from the left; empty where unknown.
  std::vector<std::optional<double>> cells;

  /// Unknown outside.
  std::optional<double> at(int column, int row) const;
};

/// Reads occupancy_grid.csv. Throws files::FileError whose text begins `file:line: ` where the file
/// is none.
ProbabilityTable read_occupancy_grid_csv(const std::filesystem::path& path);

}  // namespace echomap::tests
