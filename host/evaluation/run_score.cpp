// SPDX-License-Identifier: MIT
#include "host/evaluation/run_score.hpp"

#include <stdexcept>

#include "host/evaluation/truth_directory.hpp"
#include "host/exports/geojson.hpp"
#include "host/exports/pgm_yaml.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::evaluation {

namespace {

std::optional<mapping::PolygonMap> outline_of(const std::filesystem::path& run_directory) {
  const auto file = run_directory / "outline.geojson";
  return std::filesystem::exists(file) ? exports::read_outline_geojson(file) : std::nullopt;
}

}  // namespace

RunScore score_run(const std::filesystem::path& run_directory,
                   const std::filesystem::path& truth_directory) {
  const auto map = exports::read_pgm_yaml(run_directory / "map.yaml");
  const auto trajectory = exports::read_trajectory_tum(run_directory / "trajectory.tum");
  const Truth truth = read_truth(truth_directory);
  if (truth.trajectory.empty()) {
    throw files::FileError((truth_directory / "truth.tum").string() + ": holds no pose");
  }
  try {
    const geometry::Pose2 T_world_map = start_aligned(trajectory, truth.trajectory);
    return {score_map(map, T_world_map, truth.map),
            score_trajectory(trajectory, truth.trajectory),
            score_outline(outline_of(run_directory), T_world_map, first_ring(truth.map.walls))};
  } catch (const std::invalid_argument& error) {
    throw files::FileError(run_directory.string() + ": " + error.what());
  }
}

}  // namespace echomap::evaluation
