// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::evaluation {

/// The map with a margin of one unknown cell.
mapping::RasterMap padded(const mapping::RasterMap& map);

/// Takes from `floor` the free cells nearer than `margin_m` to a cell of `map` that `is_obstacle`
/// takes; both have the same size.
void keep_off(const mapping::RasterMap& map,
              const std::function<bool(mapping::CellState)>& is_obstacle,
              double margin_m,
              mapping::RasterMap& floor);

/// Takes the cells of the 4-connected free region of `seed` out of `floor`: their centres; none
/// where `seed` is not free.
std::vector<Eigen::Vector2d> take_region_m(geometry::CellIndex seed, mapping::RasterMap& floor);

}  // namespace echomap::evaluation
