// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "hil_mock/world/floor_plan.hpp"

namespace echomap::bench {

/// Intersection over union of a room's free floor and the same floor turned about its centroid,
/// counter-clockwise, on a raster of 5 cm.
double turned_floor_iou(const world::FloorPlan& plan, double turn_rad);

/// The smallest turn of 45, 60, 90, 120 and 180 degrees by which the floor of a room covers itself
/// (0.97 and more): a robot in it cannot tell how often it is turned by that. Empty where there is
/// none.
std::optional<double> symmetry_turn_rad(const world::FloorPlan& plan);

}  // namespace echomap::bench
