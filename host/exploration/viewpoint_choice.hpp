// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/cost_grid.hpp"
#include "host/exploration/frontier_search.hpp"
#include "host/exploration/travel_field.hpp"
#include "host/exploration/view_gain.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::exploration {

/// Values without another source are ours, chosen in simulation.
struct ViewpointParams {
  /// Where to look from is sought at most so far from a frontier.
  double far_m = 1.2;
  /// Places that are tried lie so far apart.
  double spacing_m = 0.2;
  /// The places nearest to the robot are tried, so many in all.
  std::size_t max_places = 200;
  /// Bearings that a sweep may cover. All round costs a turn of the body where the pan does not
  /// reach so far, but narrower ones tie a stop too loosely to the map: a stop drifts by degrees.
  std::vector<double> widths_rad{6.283185307179586};
  /// The room is done when no sweep would show more than this.
  double min_gain_m2 = 0.2;
  /// What one radian of a sweep takes.
  double sweep_s_per_rad = 1.2;
  /// Time overhead of a stop beside driving and sweeping.
  double stop_s = 1.0;
  /// Speeds of the ways there, for their time.
  double speed_m_per_s = 0.25;
  double turn_rad_per_s = 2.0;
};

/// Where to look next, and at what.
struct Viewpoint {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  BestView view;
  double cost_m = 0.0;      ///< Of the way there.
  double gain_per_s = 0.0;  ///< Square metres a second, of way and sweep.
};

/// The places that the robot can reach from `T_map_robot` and from which frontiers are near, the
/// one with the most gain for its time first (in the manner of Gonzalez-Banos and Latombe 2002).
/// Views that gain less than `params.min_gain_m2` do not count.
std::vector<Viewpoint> weigh_viewpoints(const CostGrid& grid,
                                        const TravelField& travel,
                                        const std::vector<FrontierCells>& frontiers,
                                        const ViewGain& gain,
                                        const geometry::Pose2& T_map_robot,
                                        const ViewpointParams& params);

}  // namespace echomap::exploration
