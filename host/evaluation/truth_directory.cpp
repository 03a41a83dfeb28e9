// SPDX-License-Identifier: MIT
#include "host/evaluation/truth_directory.hpp"

#include <nlohmann/json.hpp>

#include "host/exports/pgm_yaml.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::evaluation {

namespace {

Eigen::Vector2d point_of(const nlohmann::json& position) {
  return {position.at(0).get<double>(), position.at(1).get<double>()};
}

/// Every piece of every LineString; other geometries are no walls.
std::vector<geometry::Segment> segments_of(const nlohmann::json& collection) {
  std::vector<geometry::Segment> segments;
  for (const auto& feature : collection.at("features")) {
    const auto& shape = feature.at("geometry");
    if (shape.at("type") != "LineString") {
      continue;
    }
    const auto& positions = shape.at("coordinates");
    for (std::size_t i = 1; i < positions.size(); ++i) {
      segments.push_back({point_of(positions.at(i - 1)), point_of(positions.at(i))});
    }
  }
  return segments;
}

std::vector<geometry::Segment> read_walls(const std::filesystem::path& path) {
  const std::string text = files::read_text_file(path);
  try {
    return segments_of(nlohmann::json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw files::FileError(path.string() + ": " + error.what());
  }
}

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
           read_walls(directory / "truth_walls.geojson")},
          read_true_trajectory(directory / "truth.tum")};
}

}  // namespace echomap::evaluation
