// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"

namespace echomap::world {

/// Corners of a rectangle, counter-clockwise from its lower left one; metres.
inline Polygon rectangle(double left_m, double bottom_m, double right_m, double top_m) {
  return {{left_m, bottom_m}, {right_m, bottom_m}, {right_m, top_m}, {left_m, top_m}};
}

/// 4 x 3 m of smooth walls, start in the middle.
inline FloorPlan box_room(std::vector<Outline> obstacles = {},
                          const geometry::Pose2& T_world_start = {2.0, 1.5, 0.0}) {
  return {"box", {rectangle(0.0, 0.0, 4.0, 3.0), {}}, std::move(obstacles), T_world_start};
}

}  // namespace echomap::world
