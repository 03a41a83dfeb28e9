// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_grid_update.hpp"

#include <stdexcept>

namespace echomap::mapping {

SonarGridUpdate::SonarGridUpdate(const SonarGridParams& params) : params_(params) {
  if (!(params.half_angle_rad > 0.0)) {
    throw std::invalid_argument("sonar grid: the beam needs an opening angle above 0");
  }
}

void SonarGridUpdate::apply(const Scan& scan, OccupancyGrid& grid) const {
  for (const PlacedReading& reading : scan) {
    if (const auto point_m = echo_point_m(reading)) {
      grid.add(grid.cell_at(*point_m), 100);
    }
  }
}

}  // namespace echomap::mapping
