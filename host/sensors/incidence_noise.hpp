// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/sensors/wall_beam_width.hpp"

namespace echomap::sensors {

/// How ranges to walls are off where the beam's axis meets them at about one angle.
struct IncidenceNoise {
  double from_rad = 0.0;  ///< Between the axis and the wall's perpendicular, from here ...
  double to_rad = 0.0;    ///< ... to here.
  std::size_t readings = 0;
  double bias_m = 0.0;    ///< Mean of range less wall_beam_width's equation (1); positive: too far.
  double stddev_m = 0.0;  ///< About that mean; 0 for fewer than two.
};

/// Range noise by incidence over all readings of these walls, in steps of `step_rad` from 0; an
/// angle without a reading has no row. Throws std::invalid_argument for a step that is not
/// positive.
std::vector<IncidenceNoise> noise_by_incidence(std::span<const SweptWall> walls, double step_rad);

}  // namespace echomap::sensors
