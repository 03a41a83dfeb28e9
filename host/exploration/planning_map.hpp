// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/cost_grid.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exploration {

/// The map of a snapshot with `margin_m` of unknown floor around it, and with floor where it knows
/// none but the hull of the robot has been. Where the middle of the robot has been is floor even
/// where a wall is drawn: walls on both sides of a door, heard from two rooms, may overlap in it.
mapping::RasterMap planning_map(const pipeline::Snapshot& snapshot,
                                double margin_m,
                                double robot_radius_m);

/// Where the robot has been, in the order of its way; where it stands is the last.
std::vector<Eigen::Vector2d> places_of(const pipeline::Snapshot& snapshot);

/// What ways over a map cost a robot that stands, and has been, where the snapshot says.
CostGrid costs_on(const mapping::RasterMap& map,
                  const pipeline::Snapshot& snapshot,
                  const CostGridParams& params);

/// Makes the cells within `radius_m` of a point so, of those whose state is in `from`.
void draw_disc(mapping::RasterMap& map,
               const Eigen::Vector2d& at_m,
               double radius_m,
               std::initializer_list<mapping::CellState> from,
               mapping::CellState state);

}  // namespace echomap::exploration
