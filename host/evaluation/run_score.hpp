// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/evaluation/map_agreement.hpp"
#include "host/evaluation/obstacle_agreement.hpp"
#include "host/evaluation/outline_agreement.hpp"
#include "host/evaluation/path_agreement.hpp"
#include "host/evaluation/trajectory_error.hpp"

namespace echomap::evaluation {

/// How good a run's map and outline are in one placement in the world.
struct PlacedScore {
  MapAgreement map;
  ObstacleAgreement obstacles;
  PathAgreement paths;
  OutlineAgreement outline;
  double floor_seen = 0.0;  ///< Of the floor that the robot can reach.
};

/// How good a run's map, trajectory and outline are.
struct RunScore {
  PlacedScore start;   ///< Placed by `start_aligned`.
  PlacedScore fitted;  ///< Placed by `fit_aligned`, so that the pose's error is left out.
  /// From the first placement to the second, counter-clockwise.
  double fit_turn_rad = 0.0;
  TrajectoryError trajectory;
  double robot_radius_m = 0.0;  ///< Of the paths.
};

/// The radius of a robot whose run directory does not say it: that of uno_2wd.
constexpr double kDefaultRobotRadiusM = 0.09;

/// Scores map.yaml, trajectory.tum and outline.geojson, where it is, of a run directory against the
/// truth directory of the same run. Throws files::FileError.
RunScore score_run(const std::filesystem::path& run_directory,
                   const std::filesystem::path& truth_directory,
                   double robot_radius_m = kDefaultRobotRadiusM);

}  // namespace echomap::evaluation
