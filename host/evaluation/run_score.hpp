// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/evaluation/map_agreement.hpp"
#include "host/evaluation/outline_agreement.hpp"
#include "host/evaluation/trajectory_error.hpp"

namespace echomap::evaluation {

/// How good a run's map, trajectory and outline are.
struct RunScore {
  MapAgreement map;
  TrajectoryError trajectory;
  OutlineAgreement outline;
};

/// Scores map.yaml, trajectory.tum and outline.geojson, where it is, of a run directory against the
/// truth directory of the same run. The map is placed in the world by the first pose of the
/// trajectory that the truth knows, and by nothing else. Throws files::FileError.
RunScore score_run(const std::filesystem::path& run_directory,
                   const std::filesystem::path& truth_directory);

}  // namespace echomap::evaluation
