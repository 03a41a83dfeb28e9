// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/cost_grid.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/team_exploration/team_view.hpp"

namespace echomap::team_exploration {

/// A place where a robot lets another one pass.
struct PassingPlace {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double cost_m = 0.0;  ///< Cost of the path there, in metres of open floor.
};

/// Values are ours, chosen in simulation.
struct StepAsideParams {
  exploration::CostGridParams costs;
  /// Largest cost of the path to a place.
  double max_cost_m = 6.0;
  /// Distance that a peer without a claim is expected to drive straight ahead.
  double straight_m = 1.5;
};

/// Path that a peer is expected to take: over the map to what it claims, or straight ahead where it
/// claims nothing or no path leads there.
std::vector<Eigen::Vector2d> expected_path(const mapping::RasterMap& map,
                                           const Peer& peer,
                                           const Claim* claim,
                                           const StepAsideParams& params);

/// Floor that a robot has to leave free: this far from a path.
struct ClearPath {
  std::vector<Eigen::Vector2d> points_m;
  double keep_off_m = 0.0;
};

/// The nearest place to a robot at `here_m` that leaves a path clear, and that the robot can reach
/// past all peers. Empty where there is none.
std::optional<PassingPlace> passing_place(const mapping::RasterMap& map,
                                          const Eigen::Vector2d& here_m,
                                          const std::vector<Peer>& peers,
                                          const ClearPath& path,
                                          const StepAsideParams& params);

}  // namespace echomap::team_exploration
