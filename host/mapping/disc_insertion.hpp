// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "host/mapping/occupancy_grid.hpp"

namespace echomap::mapping {

/// Adds evidence, hundredths of log-odds, to every cell that lies within a disc with all of its
/// area. A disc that is not finite adds nothing.
void insert_disc(const Eigen::Vector2d& middle_m,
                 double radius_m,
                 int centilogits,
                 OccupancyGrid& grid);

}  // namespace echomap::mapping
