// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/cost_grid.hpp"
#include "host/exploration/explorer.hpp"

namespace echomap::exploration {

/// Values without another source are ours, chosen in simulation.
struct PathFollowerParams {
  /// Over open floor (robot profile).
  double speed_m_per_s = 0.25;
  /// Beside what is not free, and at the end of the way.
  double min_speed_m_per_s = 0.12;
  /// To slow down with: half of what the motors do (0.6 m/s^2 of uno_2wd's profile).
  double braking_m_per_s2 = 0.3;
  /// The point of the way that is steered for lies so far ahead.
  double look_ahead_m = 0.15;
  /// A larger error of heading is turned away on the spot.
  double turn_on_spot_rad = 0.6;
  /// How long one Roll lasts before the next look: an order of magnitude shorter than the look
  /// ahead takes.
  double roll_s = 0.1;
  /// So near to its end the way is done.
  double arrived_m = 0.04;
};

/// How many motions a way of `path_m` metres may take: twice what it takes at the lowest speed, and
/// some turns.
std::size_t max_motions(double path_m, const PathFollowerParams& params);

/// Leads a robot along a way of straight pieces by pure pursuit (Coulter 1992): it rolls on the
/// circle through the robot and a point of the way ahead of it, the slower the dearer the floor.
class PathFollower {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit PathFollower(const PathFollowerParams& params = {});

  /// Takes a new way.
  void follow(std::vector<Eigen::Vector2d> path_m);
  /// The next Turn or Roll; empty once the robot has arrived, or has no way.
  std::optional<Motion> next(const geometry::Pose2& T_map_robot, const CostGrid& grid);

 private:
  Eigen::Vector2d target_m(const Eigen::Vector2d& here_m);
  double speed_m_per_s(const Eigen::Vector2d& here_m, const CostGrid& grid) const;

  PathFollowerParams params_;
  std::vector<Eigen::Vector2d> path_m_;
  std::size_t piece_ = 0;  ///< The robot is on the way from this point to the next.
};

}  // namespace echomap::exploration
