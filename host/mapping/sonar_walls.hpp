// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/geometry/segment.hpp"
#include "host/mapping/sonar_view.hpp"

namespace echomap::mapping {

/// When two views have heard one wall.
struct SonarWallParams {
  /// Echoes of one wall agree to this: some three times the noise of the sensor kind.
  double range_tolerance_m = 0.06;
  /// Views nearer together give no direction, views farther apart rarely hear one wall.
  double min_baseline_m = 0.08;
  double max_baseline_m = 2.0;
  /// Between two feet farther apart there is room for a door.
  double longest_piece_m = 1.5;
};

/// The pieces of wall between neighbouring views: common tangents of their arcs (Tardos et al. 2002
/// with Leonard and Durrant-Whyte's regions of constant depth). A smooth wall answers wherever the
/// foot of the perpendicular is in the cone, so both views must have heard it with every reading
/// whose cone holds its direction, no third view with its foot on the piece may have missed it, and
/// no piece that was heard from nearer may stand before it.
std::vector<geometry::Segment> find_sonar_walls(const std::vector<SonarView>& views,
                                                double beam_half_angle_rad,
                                                double max_range_m,
                                                const SonarWallParams& params);

}  // namespace echomap::mapping
