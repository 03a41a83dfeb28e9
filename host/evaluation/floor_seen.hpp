// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::evaluation {

/// Centres, in the world frame, of the cells of `truth` that are floor in the robot's reach: what
/// its hull can come over, wherever its centre can be, but for the 5 cm along walls that a map's
/// own wall cells may cover. Its centre can be where the truly free floor is the robot's radius
/// away from all that is not and hangs together with `start_m` (world frame). Throws
/// std::invalid_argument for a radius that is not above zero.
std::vector<Eigen::Vector2d> floor_in_reach_m(const mapping::RasterMap& truth,
                                              const Eigen::Vector2d& start_m,
                                              double robot_radius_m);

/// Share of the floor in the robot's reach that the map calls free; 1 where it can reach none.
/// `T_world_map` places the map in the world; nothing is fitted. Throws as floor_in_reach_m.
double floor_seen(const mapping::RasterMap& map,
                  const geometry::Pose2& T_world_map,
                  const mapping::RasterMap& truth,
                  const Eigen::Vector2d& start_m,
                  double robot_radius_m);

}  // namespace echomap::evaluation
