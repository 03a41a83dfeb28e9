// SPDX-License-Identifier: MIT
#pragma once

#include "host/geometry/polygon.hpp"

namespace echomap::mapping {

/// The ring without corners that are none, within a millimetre, and without the loops of sides that
/// cross, as long as a loop is no larger than `max_loop_m2`: larger ones stay, and the sides that
/// cross with them.
geometry::Polygon without_small_loops(geometry::Polygon ring_m, double max_loop_m2);

}  // namespace echomap::mapping
