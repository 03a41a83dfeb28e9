// SPDX-License-Identifier: MIT
#include "host/evaluation/truth_directory.hpp"

#include "host/exports/geojson.hpp"
#include "host/exports/pgm_yaml.hpp"
#include "host/exports/trajectory_tum.hpp"

namespace echomap::evaluation {

namespace {

/// The mock writes TUM lines as the host does, but in the world frame.
std::vector<TruePose> read_true_trajectory(const std::filesystem::path& path) {
  std::vector<TruePose> trajectory;
  for (const auto& [stamp, T_world_robot] : exports::read_trajectory_tum(path)) {
    trajectory.push_back({stamp, T_world_robot});
  }
  return trajectory;
}

}  // namespace

Truth read_truth(const std::filesystem::path& directory) {
  return {{exports::read_pgm_yaml(directory / "truth_map.yaml"),
           exports::read_line_strings(directory / "truth_walls.geojson")},
          read_true_trajectory(directory / "truth.tum")};
}

}  // namespace echomap::evaluation
