// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/exports/map_style.hpp"
#include "host/exports/summary_json.hpp"
#include "host/geometry/polygon.hpp"
#include "host/mapping/polygon_map.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// Sets the fields of a summary that follow from what the pipeline knows: stops, poses, points,
/// length and area.
void describe_snapshot(const pipeline::Snapshot& snapshot, RunSummary& summary);

/// Sets what the covariance of x, y (m) and heading (rad) says of the last pose.
void describe_uncertainty(const Eigen::Matrix3d& covariance, RunSummary& summary);

/// What a run directory's outline and pictures are made with beside the snapshot.
struct RunDrawing {
  /// The outline that the strategy has drawn itself; empty: mapping::room_outline.
  geometry::Polygon outline_m{};
  /// Whether map.png and map.svg are turned to the room's main direction.
  bool align = true;
  double robot_radius_m = 0.09;
  /// Whether map.png and map.svg hold every echo: of a map of points.
  bool holds_echoes = false;
  /// What the pictures' title begins with; empty: room and robot of the summary.
  std::string name{};
  MapLandmarks landmarks{};
};

/// What the pictures of a run directory are drawn of beside the snapshot.
struct RunPictures {
  mapping::RasterMap map;
  std::optional<mapping::PolygonMap> outline;
  std::vector<bool> is_open;  ///< Of the outline's sides.
  MapStyle style;
};

/// The pictures of a run directory, as `write_run_directory` draws them.
RunPictures pictures_of(const pipeline::Snapshot& snapshot,
                        const RunSummary& summary,
                        const RunDrawing& drawing);

/// Writes map.yaml, map.pgm, occupancy_grid.csv, map.png, map.svg, outline.geojson, points.csv,
/// poses.csv, trajectory.tum and summary.json into `directory`, which is made where it is missing.
/// Each file is whole or absent. Throws files::FileError, and std::invalid_argument for an outline
/// that is none.
void write_run_directory(const std::filesystem::path& directory,
                         const pipeline::Snapshot& snapshot,
                         const RunSummary& summary,
                         const RunDrawing& drawing = {});

}  // namespace echomap::exports
