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
  /// Whether there is certainly no solid between a place and all points of a disc; false may be
  /// wrong.
  bool is_clear(const Eigen::Vector2d& from_m,
                const Eigen::Vector2d& middle_m,
                double radius_m) const;

 private:
  /// How far around a point there is certainly no solid; 0 or less for none, and outside.
  double clearance_m(const Eigen::Vector2d& at_m) const;

  mapping::DistanceField field_;
};

}  // namespace echomap::source_search
