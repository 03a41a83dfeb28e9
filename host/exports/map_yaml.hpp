// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <Eigen/Core>

namespace echomap::exports {

/// What a ROS map_server YAML file says about its picture. The defaults are those of map_saver.
struct MapYaml {
  /// Relative to the YAML file.
  std::string image;
  double resolution_m = 0.0;
  /// The picture's lower left corner in the map frame; its rotation must be 0.
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
  bool negate = false;
  double occupied_threshold = 0.65;
  double free_threshold = 0.196;
};

/// Throws files::FileError.
void write_map_yaml(const std::filesystem::path& path, const MapYaml& yaml);

/// Reads `key: value` lines; keys it does not know are skipped, as map_server does. Numbers are
/// finite and the mode, where one is named, is trinary or scale. Throws files::FileError whose text
/// begins `file:line: `.
MapYaml read_map_yaml(const std::filesystem::path& path);

}  // namespace echomap::exports
