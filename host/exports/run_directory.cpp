// SPDX-License-Identifier: MIT
#include "host/exports/run_directory.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

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
#include "host/geometry/main_direction.hpp"
#include "host/mapping/open_sides.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/mapping/room_outline.hpp"

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

/// Of the fitted walls or, where there are none, of the outline.
double main_direction_rad(const pipeline::Snapshot& snapshot,
                          const std::optional<mapping::PolygonMap>& outline) {
  std::vector<geometry::Segment> walls = snapshot.features->walls;
  if (walls.empty() && outline) {
    for (std::size_t i = 0; i < outline->outline_m().size(); ++i) {
      walls.push_back(geometry::side(outline->outline_m(), i));
    }
  }
  return geometry::main_direction_rad(walls);
}

/// As "living_room by uno_2wd".
std::string name_of(const RunSummary& summary) {
  const std::string room = std::filesystem::path(summary.world).stem().string();
  if (room.empty() || summary.robot.empty()) {
    return room + summary.robot;
  }
  return room + " by " + summary.robot;
}

/// As ", 4.0 x 3.5 m, 13.2 m2 of floor": length and width of the outline in the picture's axes.
std::string size_text(const mapping::PolygonMap& outline, double turn_rad) {
  const Eigen::Rotation2Dd R_picture_map(-turn_rad);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner_m : outline.outline_m()) {
    box.extend(R_picture_map * corner_m);
  }
  return fmt::format(
      "{:.1f} x {:.1f} m, {:.1f} m2 of floor", box.sizes().x(), box.sizes().y(), outline.area_m2());
}

std::string title_of(const RunDrawing& drawing,
                     const RunSummary& summary,
                     const std::optional<mapping::PolygonMap>& outline,
                     double turn_rad) {
  const std::string name = drawing.name.empty() ? name_of(summary) : drawing.name;
  const std::string size = outline ? size_text(*outline, turn_rad) : "";
  return name + (name.empty() || size.empty() ? "" : ": ") + size;
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

RunPictures pictures_of(const pipeline::Snapshot& snapshot,
                        const RunSummary& summary,
                        const RunDrawing& drawing) {
  RunPictures pictures{mapping::rasterize(*snapshot.grid), {}, {}, {}};
  if (drawing.outline_m.empty()) {
    pictures.outline = mapping::room_outline(pictures.map, *snapshot.features);
  } else {
    pictures.outline.emplace(drawing.outline_m);
  }
  if (pictures.outline) {
    pictures.is_open =
        mapping::open_sides(pictures.outline->outline_m(), pictures.map, *snapshot.features);
  }
  pictures.style.turn_rad = drawing.align ? main_direction_rad(snapshot, pictures.outline) : 0.0;
  pictures.style.robot_radius_m = drawing.robot_radius_m;
  pictures.style.landmarks = drawing.landmarks;
  pictures.style.holds_echoes = drawing.holds_echoes;
  pictures.style.title = title_of(drawing, summary, pictures.outline, pictures.style.turn_rad);
  return pictures;
}

void write_run_directory(const std::filesystem::path& directory,
                         const pipeline::Snapshot& snapshot,
                         const RunSummary& summary,
                         const RunDrawing& drawing) {
  make_directory(directory);
  write_points_csv(directory / "points.csv", snapshot.points->points());
  write_poses_csv(directory / "poses.csv", snapshot.points->poses());
  const RunPictures pictures = pictures_of(snapshot, summary, drawing);
  write_pgm_yaml(directory / "map.yaml", pictures.map);
  write_occupancy_grid_csv(directory / "occupancy_grid.csv", *snapshot.grid);
  write_trajectory_tum(directory / "trajectory.tum", *snapshot.trajectory);
  write_outline_geojson(directory / "outline.geojson", pictures.outline, pictures.is_open);
  write_map_png(directory / "map.png", snapshot, pictures.outline, pictures.style);
  write_map_svg(directory / "map.svg", snapshot, pictures.outline, pictures.style);
  write_summary_json(directory / "summary.json", summary);
}

}  // namespace echomap::exports
