// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/localization/pose_gaussian.hpp"
#include "tests/benchmarks/landmark_runs.hpp"

namespace echomap::bench {

/// Where a robot truly was, by the seconds of its log.
class TruePath {
 public:
  void add(double stamp_s, const geometry::Pose2& T_map_robot);
  /// On the straight line between two poses; empty beyond the ends and in gaps of half a second.
  std::optional<geometry::Pose2> at(double stamp_s) const;

 private:
  std::vector<std::pair<double, geometry::Pose2>> poses_;
};

/// Adds up errors of a filter.
class FollowTally {
 public:
  void count(const localization::PoseGaussian& belief,
             const geometry::Pose2& truth,
             const geometry::Pose2& dead_reckoning,
             bool with_heading);
  FollowScore score(std::size_t gated) const;

 private:
  FollowScore sums_;
};

}  // namespace echomap::bench
