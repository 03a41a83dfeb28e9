// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/geometry/polygon.hpp"

namespace echomap::evaluation {

/// The outline of a room's floor: that of the room, the first ring, without the obstacles that
/// stand at its walls, since a sonar cannot tell a cupboard at a wall from the wall. Of several
/// parts of the floor the largest. What stands free of the walls is no part of it. Empty without a
/// ring.
geometry::Polygon floor_outline(const std::vector<geometry::Polygon>& rings);

}  // namespace echomap::evaluation
