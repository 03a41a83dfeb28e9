// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "host/exploration/cell_values.hpp"
#include "host/mapping/distance_field.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::source_search {

/// Lengths of what the straight line from a source to a sensor crosses.
struct CrossedLengths {
  double solid_m = 0.0;    ///< In occupied cells.
  double unknown_m = 0.0;  ///< In unknown cells, each by how likely it is not floor.
};

/// How much solid lies between two places of a floor. What is outside of the map is air.
class SolidLengths {
 public:
  /// `floor_chance` is how likely unknown cells are floor that a path leads to. A source lies in
  /// air: the unknown cells around it, on each line up to `hollow_m`, do not count.
  SolidLengths(const mapping::RasterMap& map,
               const exploration::CellValues<float>& floor_chance,
               double hollow_m);

  /// Lengths between two places, accurate to half a cell for each wall that is crossed.
  CrossedLengths between(const Eigen::Vector2d& sensor_m, const Eigen::Vector2d& source_m) const;
  /// Whether there is certainly nothing solid, nor unknown that may be, between a place and all
  /// points of a disc; false may be wrong.
  bool is_clear(const Eigen::Vector2d& from_m,
                const Eigen::Vector2d& middle_m,
                double radius_m) const;
  /// Whether any unknown cell may be solid.
  bool has_unknown() const { return has_unknown_; }

 private:
  /// Radius around a point that is certainly free; 0 or less for none, and outside.
  double clearance_m(const Eigen::Vector2d& at_m) const;

  double hollow_m_;
  bool has_unknown_ = false;
  exploration::CellValues<float> unknown_;  ///< How likely an unknown cell is not floor.
  mapping::DistanceField field_;            ///< To the nearest cell that is or may be solid.
};

}  // namespace echomap::source_search
