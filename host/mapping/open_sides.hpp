// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/geometry/polygon.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/mapping/sonar_features.hpp"

namespace echomap::mapping {

/// By side of an outline whether it is open: less than half of its length is at a fitted wall or an
/// occupied cell, so that the room may go on beyond it.
std::vector<bool> open_sides(const geometry::Polygon& outline_m,
                             const RasterMap& map,
                             const SonarFeatures& features);

}  // namespace echomap::mapping
