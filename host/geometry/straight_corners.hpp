// SPDX-License-Identifier: MIT
#pragma once

#include "host/geometry/polygon.hpp"

namespace echomap::geometry {

/// The ring without the corners that are no farther than `tolerance_m` from the straight piece
/// between their neighbours. At least three corners stay.
Polygon without_straight_corners(Polygon ring_m, double tolerance_m);

}  // namespace echomap::geometry
