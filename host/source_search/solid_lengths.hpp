// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "host/mapping/distance_field.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::source_search {

/// How much solid lies between two places of a map: the length in occupied cells. Unknown cells and
/// what is outside of the map are air.
class SolidLengths {
 public:
  explicit SolidLengths(const mapping::RasterMap& map);

  /// Metres of solid on the straight line, right to half a cell for each wall that is crossed.
  double between_m(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const;

 private:
  mapping::DistanceField field_;
};

}  // namespace echomap::source_search
