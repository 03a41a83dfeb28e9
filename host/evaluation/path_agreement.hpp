// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "host/evaluation/map_agreement.hpp"
#include "host/geometry/pose2.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::evaluation {

/// Whether paths that are planned on the map can be driven in truth. All distances are those of the
/// robot's centre.
///
/// 200 pairs of start and goal are sampled with a fixed seed on the largest connected part of the
/// truly free floor that is the robot's radius + 5 cm away from all that is not, so the truth
/// connects every pair. A path is a shortest one over free cells of the map (A* from cell to cell,
/// eight neighbours) whose centres are the radius + 5 cm away from those of occupied cells and 10
/// cm from those of unknown ones, between the cells nearest to start and goal that fulfil this,
/// within 10 cm of each.
struct PathAgreement {
  std::size_t pairs = 0;  ///< 0 where the truth has no such floor.
  std::size_t paths = 0;  ///< Pairs that have a path on the map.
  /// Paths that somewhere pass a true wall nearer than the robot's radius or leave the truly free
  /// floor.
  std::size_t collisions = 0;
};

/// `T_world_map` places the map in the world; nothing is fitted. Throws std::invalid_argument for a
/// radius that is not above zero and for a map of more than 2^14 cells along an edge.
PathAgreement score_paths(const mapping::RasterMap& map,
                          const geometry::Pose2& T_world_map,
                          const MapTruth& truth,
                          double robot_radius_m);

}  // namespace echomap::evaluation
