// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <vector>

#include "host/slam/echo_ransac.hpp"
#include "host/slam/landmark_sighting.hpp"

namespace echomap::slam {

/// What in a multiscan is taken for a landmark, and how unsure it is.
struct SonarLandmarksParams {
  EchoRansacParams search{};
  bool with_walls = true;
  bool with_points = true;
  /// What a landmark is unsure by beyond the noise of its echoes: odometry places these, and of a
  /// wall or point that something hides in part, the middle of what is heard is not its nearest
  /// point. Chosen on simulated rooms.
  double wall_offset_stddev_m = 0.03;
  double wall_normal_stddev_rad = 0.08;
  double point_stddev_m = 0.05;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const SonarLandmarksParams& params);

/// Walls and points that the echoes of a multiscan came from, seen from where it began. All points
/// have one label: a sonar does not tell a corner from an edge or a leg.
std::vector<LandmarkSighting> sonar_landmarks(const std::vector<mapping::Echo>& echoes,
                                              const SonarLandmarksParams& params,
                                              std::mt19937& random);

}  // namespace echomap::slam
