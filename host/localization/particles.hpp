// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/geometry/pose2.hpp"

namespace echomap::localization {

/// Hypotheses of the robot's pose in the map frame, one array a number. Single precision holds a
/// hall of a kilometre to 0.1 mm. Headings are in [-pi, pi]; weights are natural logarithms and
/// need not be normalized.
struct Particles {
  std::vector<float> x_m;
  std::vector<float> y_m;
  std::vector<float> heading_rad;
  std::vector<float> log_weight;

  std::size_t size() const { return x_m.size(); }
  /// New ones stand at the origin with the weight 1.
  void resize(std::size_t count);
  void set_pose(std::size_t i, const geometry::Pose2& T_map_robot);
  geometry::Pose2 pose(std::size_t i) const;
};

/// A stretch of particles, `begin` to before `end`: the share of a thread.
struct ParticleRange {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::size_t size() const { return end - begin; }
};

}  // namespace echomap::localization
