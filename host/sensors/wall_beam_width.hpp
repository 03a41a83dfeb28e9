// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "host/sensors/beam_width.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::sensors {

/// How a cone's opening is read off walls.
struct WallBeamWidthParams {
  /// Standard deviation of a range about the model, metres; half of the centimetre in which small
  /// sonars count. A wall has to rise by three of it on both sides, and to be fitted within two.
  double range_stddev_m = 0.005;
  /// Where neighbours differ by more than this share of the range and two standard deviations, one
  /// wall ends. At 5 degrees a step and 30 degrees beyond the flat a wall changes by that
  /// much.
  double jump_share = 0.05;
  std::size_t min_readings = 8;
};

/// One reading of a wall: the angle between the beam's axis and the wall's perpendicular, and the
/// range less that of equation (1) below.
struct WallReading {
  double incidence_rad = 0.0;
  double residual_m = 0.0;
};

/// One wall in a sweep, and the opening of the cone that saw it.
struct SweptWall {
  /// Where the wall is nearest, and how near.
  double bearing_rad = 0.0;
  double range_m = 0.0;
  BeamWidth beam_width;
  double residual_m = 0.0;
  std::size_t readings = 0;
  std::vector<WallReading> heard;  ///< All of these readings.
};

/// The walls in a sweep, by bearing. A cone hears the nearest thing in it, so a straight wall at
/// the distance d, square to the bearing a, is heard by a sonar with the opening w at
///
///     r(b) = d / cos(max(0, |b - a| - w / 2)):                                            (1)
///
/// the flat bottom is as wide as the cone (Hennessey et al., section III.A and figure 4). The three
/// unknowns are fitted by least squares, the bounds of w are those of its profile. It takes a wall
/// that answers beside the perpendicular, and is the wider for one that is not straight.
///
/// Bearings rise or fall throughout; a sweep that closes on itself is taken as a ring. Throws
/// std::invalid_argument for invalid parameters.
std::vector<SweptWall> swept_walls(std::span<const Beam> sweep,
                                   const WallBeamWidthParams& params = {});

/// What several walls say together.
struct PooledBeamWidth {
  /// The mean over the walls, each with the weight of the inverse square of its bounds' distance,
  /// and Student's t for the bounds: walls differ by more than their fits tell.
  BeamWidth mean;
  /// Standard deviation over the walls, weighted the same.
  double spread_rad = 0.0;
};

/// Empty for fewer than three walls.
std::optional<PooledBeamWidth> pooled_beam_width(std::span<const SweptWall> walls);

}  // namespace echomap::sensors
