// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/geometry/segment.hpp"

namespace echomap::geometry {

/// The direction that most of the length of these walls is parallel or at right angles to, in
/// (-pi/4, pi/4]: the circular mean of four times their directions, each weighted by its length,
/// then once more of those near to it. 0 where the walls prefer none, as those of a round room.
double main_direction_rad(const std::vector<Segment>& walls);

}  // namespace echomap::geometry
