// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "host/evaluation/map_agreement.hpp"
#include "host/evaluation/trajectory_error.hpp"

namespace echomap::evaluation {

/// What the simulated world wrote down about itself and the robot, in the world frame.
struct Truth {
  MapTruth map;
  std::vector<TruePose> trajectory;
};

/// Reads truth_map.yaml with its PGM, truth_walls.geojson (LineStrings) and truth.tum. Throws
/// files::FileError that names the file.
Truth read_truth(const std::filesystem::path& directory);

}  // namespace echomap::evaluation
