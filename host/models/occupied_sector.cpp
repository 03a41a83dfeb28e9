// SPDX-License-Identifier: MIT
#include "host/models/occupied_sector.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/models/concepts.hpp"

namespace echomap::models {

static_assert(InverseModel<OccupiedSector>);

OccupiedSector::OccupiedSector(const OccupiedSectorParams& params) : params_(params) {
  const bool lengths_ok = params.thickness_m > 0.0 && params.max_range_m > 0.0;
  const bool evidence_ok = params.occupied_log_odds > 0.0 && params.free_log_odds < 0.0;
  if (!lengths_ok || !evidence_ok || params.opening_rad <= 0.0) {
    throw std::invalid_argument("occupied sector: a parameter is outside of its range");
  }
}

double OccupiedSector::evidence(const SensorReading& reading, const PolarPoint& point) const {
  const double z_m = reading.range_m.value_or(params_.max_range_m);
  if (point.range_m > reach_m(reading) ||
      std::abs(point.off_axis_rad) > 0.5 * params_.opening_rad) {  // Line 6.
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
