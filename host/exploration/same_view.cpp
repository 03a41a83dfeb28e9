// SPDX-License-Identifier: MIT
#include "host/exploration/same_view.hpp"

#include <cmath>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {
namespace {

/// Which way a reading looks.
using Bearing = double (*)(const mapping::PlacedReading& reading);

double in_the_map_rad(const mapping::PlacedReading& reading) {
  return reading.T_map_sonar.heading_rad();
}

double from_the_body_rad(const mapping::PlacedReading& reading) {
  return geometry::angle_between(reading.T_map_robot.heading_rad(),
                                 reading.T_map_sonar.heading_rad());
}

/// The reading of the scan that is nearest in bearing, within the tolerance; null for none.
const mapping::PlacedReading* reading_at(const mapping::Scan& scan,
                                         double bearing_rad,
                                         double within_rad,
                                         Bearing bearing) {
  const mapping::PlacedReading* nearest = nullptr;
  for (const auto& reading : scan) {
    const double off_rad = std::abs(geometry::angle_between(bearing_rad, bearing(reading)));
    if (reading.range_m && off_rad <= within_rad) {
      within_rad = off_rad;
      nearest = &reading;
    }
  }
  return nearest;
}

bool is_same_by(Bearing bearing,
                const mapping::Scan& one,
                const mapping::Scan& other,
                const SameViewParams& params) {
  std::size_t pairs = 0;
  std::size_t same = 0;
  for (const auto& reading : one) {
    const auto* counterpart = reading.range_m
                                  ? reading_at(other, bearing(reading), params.bearing_rad, bearing)
                                  : nullptr;
    if (counterpart != nullptr) {
      ++pairs;
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): both have one
      same += std::abs(*counterpart->range_m - *reading.range_m) <= params.range_m ? 1 : 0;
    }
  }
  return pairs >= params.min_pairs &&
         static_cast<double>(same) >= params.share * static_cast<double>(pairs);
}

}  // namespace

bool is_same_view(const mapping::Scan& one,
                  const mapping::Scan& other,
                  const SameViewParams& params) {
  return is_same_by(in_the_map_rad, one, other, params) ||
         is_same_by(from_the_body_rad, one, other, params);
}

}  // namespace echomap::exploration
