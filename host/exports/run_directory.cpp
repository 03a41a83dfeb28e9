// SPDX-License-Identifier: MIT
#include "host/exports/run_directory.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "host/exports/geojson.hpp"
#include "host/exports/grid_csv.hpp"
#include "host/exports/map_png.hpp"
#include "host/exports/map_svg.hpp"
#include "host/exports/pgm_yaml.hpp"
#include "host/exports/points_csv.hpp"
#include "host/exports/poses_csv.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "host/mapping/polygon_map.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exports {

namespace {

/// Of the way that the wheels drove, without the hops between.
double driven_m(const pipeline::Snapshot& snapshot) {
  const auto& poses = *snapshot.trajectory;
  const auto& carried_to = snapshot.carried_to;
  double driven_m = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (std::find(carried_to.begin(), carried_to.end(), i) == carried_to.end()) {
      driven_m +=
          (poses[i].T_map_robot.position_m() - poses[i - 1].T_map_robot.position_m()).norm();
    }
  }
  return driven_m;
}

void make_directory(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    throw files::FileError(directory.string() + ": cannot make the directory: " + error.message());
  }
}

}  // namespace

void describe_snapshot(const pipeline::Snapshot& snapshot, RunSummary& summary) {
  summary.stops = snapshot.stops;
  summary.poses = snapshot.points->poses().size();
  summary.points = snapshot.points->points().size();
  summary.travelled_m = driven_m(snapshot);
  const mapping::OccupancyGrid empty;
  summary.free_area_m2 = mapping::newly_free_area_m2(empty, *snapshot.grid);
}

void describe_uncertainty(const Eigen::Matrix3d& covariance, RunSummary& summary) {
  summary.pose_stddev_m = std::sqrt(covariance(0, 0) + covariance(1, 1));
  summary.pose_stddev_deg = geometry::degrees(std::sqrt(covariance(2, 2)));
}

void write_run_directory(const std::filesystem::path& directory,
                         const pipeline::Snapshot& snapshot,
                         const RunSummary& summary,
                         const geometry::Polygon& outline_m) {
  make_directory(directory);
  write_points_csv(directory / "points.csv", snapshot.points->points());
  write_poses_csv(directory / "poses.csv", snapshot.points->poses());
  const mapping::RasterMap map = mapping::rasterize(*snapshot.grid);
  write_pgm_yaml(directory / "map.yaml", map);
  write_occupancy_grid_csv(directory / "occupancy_grid.csv", *snapshot.grid);
  write_trajectory_tum(directory / "trajectory.tum", *snapshot.trajectory);
  write_map_png(directory / "map.png", snapshot);
  const auto polygon = outline_m.empty() ? mapping::polygon_from_raster(map)
                                         : std::optional(mapping::PolygonMap(outline_m));
  write_outline_geojson(directory / "outline.geojson", polygon);
  write_map_svg(directory / "map.svg", snapshot, polygon);
  write_summary_json(directory / "summary.json", summary);
}

}  // namespace echomap::exports
