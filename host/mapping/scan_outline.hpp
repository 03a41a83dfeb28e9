// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/mapping/sonar_surfaces.hpp"

namespace echomap::mapping {

/// The floor that one stop could look over: the star-shaped area around it whose border runs from
/// surface to surface in a straight line.
class ScanOutline {
 public:
  /// Between neighbours farther apart than `max_gap_rad` nothing is known.
  ScanOutline(const ScanSurfaces& scan, double max_gap_rad);

  /// From the centre to the border at that bearing; 0 where nothing is known.
  double range_m(double bearing_rad) const;
  /// To the farthest corner of the border; 0 without any surface.
  double max_m() const;

 private:
  struct Corner {
    double bearing_rad = 0.0;
    /// From the centre.
    Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
  };

  std::vector<Corner> corners_;
  double max_gap_rad_;
};

}  // namespace echomap::mapping
