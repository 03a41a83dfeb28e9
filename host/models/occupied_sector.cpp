// SPDX-License-Identifier: MIT
#include "host/models/occupied_sector.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/models/concepts.hpp"

namespace echomap::models {

static_assert(InverseModel<OccupiedSector>);

OccupiedSector::OccupiedSector(const OccupiedSectorParams& params) : params_(params) {
  geometry::ParameterValidator("occupied sector")
      .positive("thickness_m", params.thickness_m)
      .positive("max_range_m", params.max_range_m)
      .positive("occupied_log_odds", params.occupied_log_odds)
      .below("free_log_odds", params.free_log_odds, 0.0)
      .positive("beam_width_rad", params.beam_width_rad);
}

double OccupiedSector::evidence(const SensorReading& reading, const PolarPoint& point) const {
  const double z_m = reading.range_m.value_or(params_.max_range_m);
  if (point.range_m > reach_m(reading) ||
      std::abs(point.off_axis_rad) > 0.5 * params_.beam_width_rad) {  // Line 6.
    return 0.0;
  }
  if (z_m < params_.max_range_m &&
      std::abs(point.range_m - z_m) < 0.5 * params_.thickness_m) {  // Line 8.
    return params_.occupied_log_odds;
  }
  return point.range_m <= z_m ? params_.free_log_odds : 0.0;  // Line 10.
}

double OccupiedSector::reach_m(const SensorReading& reading) const {
  const double z_m = reading.range_m.value_or(params_.max_range_m);
  return std::min(params_.max_range_m, z_m + 0.5 * params_.thickness_m);
}

}  // namespace echomap::models
