// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/mapping/sonar_surfaces.hpp"
#include "host/mapping/surface_matching.hpp"

namespace echomap::mapping {

/// What a stop may say of the floor around it. Ours, chosen in simulated rooms.
struct StopFloorParams {
  /// Between two surfaces farther apart than this a stop knows nothing of the floor.
  double max_gap_rad = 1.1;
  /// Floor nearer to the border between two surfaces than this is not called free: noise and half a
  /// cell.
  double margin_m = 0.04;
  /// A wall hides the floor behind it for so far beyond its seen ends, too.
  double hidden_beyond_ends_m = 0.1;
  /// The readings this near to a direction tell of it.
  double looks_half_angle_rad = 0.11;
};

/// How far the floor reaches from one stop, all around. In the direction of a wall that stops agree
/// on it reaches to the wall, where no reading in that direction was nearer; anywhere else to the
/// outline of the surfaces that the stop itself has heard.
class StopFloor {
 public:
  StopFloor(const ScanSurfaces& scan,
            const std::vector<MatchedWall>& walls,
            const SonarSurfaceParams& beam,
            const StopFloorParams& params);

  /// From the stop's centre; 0 where nothing is known.
  double reach_m(double bearing_rad) const;
  double max_m() const;

 private:
  std::vector<double> reaches_m_;  ///< By bearing, a full turn from -pi on.
};

}  // namespace echomap::mapping
