// SPDX-License-Identifier: MIT
#pragma once

#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/placed_reading.hpp"

namespace echomap::mapping {

struct SonarGridParams {
  /// Half the opening angle of the beam, radians (HC-SR04 and NXT sonar: 13 to 16 degrees).
  double half_angle_rad = 0.2443;
};

/// Turns the readings of one scan into evidence for cells.
class SonarGridUpdate {
 public:
  explicit SonarGridUpdate(const SonarGridParams& params = {});

  void apply(const Scan& scan, OccupancyGrid& grid) const;

 private:
  SonarGridParams params_;
};

}  // namespace echomap::mapping
