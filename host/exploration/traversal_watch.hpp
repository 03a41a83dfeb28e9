// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "host/exploration/wall_walk.hpp"

namespace echomap::exploration {

/// When a walk has come round; ours, chosen in simulation.
struct TraversalParams {
  /// Odometry errs: so near to its beginning, and this share of the way, the walk is back at it.
  double reach_m = 0.20;
  double reach_per_m = 0.02;
  /// A full turn may lack so much, as where the robot swings about the wall's direction.
  double turn_slack_rad = 0.7;
};

/// How far a walk is.
enum class Traversal : std::uint8_t {
  kUnderway,
  kRoundRoom,    ///< Back at its beginning after a full turn to the left: all of the outer wall.
  kRoundIsland,  ///< After a full turn to the right: round something that stands in the room.
};

/// Notices when a walk with the right hand on the wall is back where it began.
class TraversalWatch {
 public:
  /// Throws std::invalid_argument for a parameter below zero.
  explicit TraversalWatch(const TraversalParams& params = {});

  void add(const WallStep& step);

  /// Back at the first contact, with a full turn of the heading made since.
  Traversal state() const { return state_; }
  /// The way to there; 0 while underway.
  double round_m() const { return round_m_; }
  /// The paper's criterion (Mukherjee et al., section IV): the angle about the place where the
  /// robot started, whole turns counted, that the walk has covered. A full turn is a full traversal
  /// in rooms of which the robot sees all from where it started.
  double covered_rad() const { return covered_rad_; }

 private:
  TraversalParams params_;
  std::optional<WallStep> first_;
  std::optional<double> along_turned_rad_;  ///< Where the robot first went along the wall.
  double bearing_rad_ = 0.0;
  double covered_rad_ = 0.0;
  Traversal state_ = Traversal::kUnderway;
  double round_m_ = 0.0;
};

}  // namespace echomap::exploration
