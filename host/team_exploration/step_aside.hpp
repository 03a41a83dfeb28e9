// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/cost_grid.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/team_exploration/team_view.hpp"

namespace echomap::team_exploration {

/// Where a robot lets another one pass.
struct PassingPlace {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double cost_m = 0.0;  ///< Of the way there, in metres of open floor.
};

/// Values are ours, chosen in simulation.
struct StepAsideParams {
  exploration::CostGridParams costs;
  /// A place is sought along so much way.
  double max_cost_m = 6.0;
  /// A peer that claims nothing is expected to go straight ahead for so long.
  double straight_m = 1.5;
};

/// The way that a peer is expected to take: over the map to what it claims, or straight ahead where
/// it claims nothing or no way leads there.
std::vector<Eigen::Vector2d> expected_way(const mapping::RasterMap& map,
                                          const Peer& peer,
                                          const Claim* claim,
                                          const StepAsideParams& params);

/// Floor that a robot has to leave free: this far from a way.
struct ClearWay {
  std::vector<Eigen::Vector2d> points_m;
  double keep_off_m = 0.0;
};

/// The nearest place to a robot at `here_m` that leaves a way clear, and to which a way leads past
/// all peers. Empty where there is none.
std::optional<PassingPlace> passing_place(const mapping::RasterMap& map,
                                          const Eigen::Vector2d& here_m,
                                          const std::vector<Peer>& peers,
                                          const ClearWay& way,
                                          const StepAsideParams& params);

}  // namespace echomap::team_exploration
