// SPDX-License-Identifier: MIT
#include "host/evaluation/run_score.hpp"

#include <stdexcept>

#include "host/evaluation/floor_outline.hpp"
#include "host/evaluation/floor_seen.hpp"
#include "host/evaluation/truth_directory.hpp"
#include "host/exports/geojson.hpp"
#include "host/exports/pgm_yaml.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::evaluation {

namespace {

std::optional<mapping::PolygonMap> outline_of(const std::filesystem::path& run_directory) {
  const auto file = run_directory / "outline.geojson";
  return std::filesystem::exists(file) ? exports::read_outline_geojson(file) : std::nullopt;
}

}  // namespace

RunScore score_run(const std::filesystem::path& run_directory,
                   const std::filesystem::path& truth_directory,
                   double robot_radius_m) {
  const auto map = exports::read_pgm_yaml(run_directory / "map.yaml");
  const auto outline = outline_of(run_directory);
  const auto trajectory = exports::read_trajectory_tum(run_directory / "trajectory.tum");
  const Truth truth = read_truth(truth_directory);
  if (truth.trajectory.empty()) {
    throw files::FileError((truth_directory / "truth.tum").string() + ": holds no pose");
  }
  const auto floor_m = floor_outline(closed_rings(truth.map.walls));
  const auto placed = [&](const geometry::Pose2& T_world_map) -> PlacedScore {
    return {score_map(map, T_world_map, truth.map),
            score_obstacles(map, T_world_map, truth.map),
            score_paths(map, T_world_map, truth.map, robot_radius_m),
            score_outline(outline, T_world_map, floor_m),
            floor_seen(map,
                       T_world_map,
                       truth.map.cells,
                       truth.trajectory.front().T_world_robot.position_m(),
                       robot_radius_m)};
  };
  try {
    const geometry::Pose2 T_world_start = start_aligned(trajectory, truth.trajectory);
    const geometry::Pose2 T_world_fitted = fit_aligned(trajectory, truth.trajectory);
    return {placed(T_world_start),
            placed(T_world_fitted),
            geometry::angle_between(T_world_start.heading_rad(), T_world_fitted.heading_rad()),
            score_trajectory(trajectory, truth.trajectory),
            robot_radius_m};
  } catch (const std::invalid_argument& error) {
    throw files::FileError(run_directory.string() + ": " + error.what());
  }
}

}  // namespace echomap::evaluation
