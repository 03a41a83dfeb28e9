// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/exploration/wall_walk.hpp"
#include "host/mapping/polygon_map.hpp"

namespace echomap::exploration {

/// When a corner is one; the paper's threshold has no number.
struct CornerWatchParams {
  /// A right turn in search of the wall that is larger than this went round a corner.
  double reflex_turn_rad = 0.785;
  /// Bumps of one kind on less way than this are one corner.
  double same_corner_m = 0.25;
};

/// A corner that the robot has felt, and where the robot was.
struct CornerMark {
  mapping::CornerKind kind = mapping::CornerKind::kNonReflex;
  Eigen::Vector2d robot_m = Eigen::Vector2d::Zero();
  double travelled_m = 0.0;
};

/// Feels corners with the right hand on the wall (Mukherjee et al., section IV-B): a bump and a
/// virtual wall together are a non-reflex one, a right turn past a threshold that finds the wall
/// again is a reflex one.
class CornerWatch {
 public:
  /// Throws std::invalid_argument for a parameter that is not above zero.
  explicit CornerWatch(const CornerWatchParams& params = {});

  void add(const WallStep& step);
  const std::vector<CornerMark>& marks() const { return marks_; }

 private:
  void mark(mapping::CornerKind kind, const WallStep& step);

  CornerWatchParams params_;
  std::optional<double> lost_turned_rad_;  ///< WallStep::turned_rad where the wall was lost.
  bool turn_is_marked_ = false;
  std::vector<CornerMark> marks_;
};

}  // namespace echomap::exploration
