// SPDX-License-Identifier: MIT
#include "host/exploration/same_view.hpp"

#include <cmath>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {
namespace {

/// The reading of the scan that is nearest in bearing, within the tolerance; null for none.
const mapping::PlacedReading* reading_at(const mapping::Scan& scan,
                                         double bearing_rad,
                                         double within_rad) {
  const mapping::PlacedReading* nearest = nullptr;
  for (const auto& reading : scan) {
    const double off_rad =
        std::abs(geometry::angle_between(bearing_rad, reading.T_map_sonar.heading_rad()));
    if (reading.range_m && off_rad <= within_rad) {
      within_rad = off_rad;
      nearest = &reading;
    }
  }
  return nearest;
}

}  // namespace

bool is_same_view(const mapping::Scan& one,
                  const mapping::Scan& other,
                  const SameViewParams& params) {
  std::size_t pairs = 0;
  std::size_t same = 0;
  for (const auto& reading : one) {
    const auto* counterpart =
        reading.range_m ? reading_at(other, reading.T_map_sonar.heading_rad(), params.bearing_rad)
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

}  // namespace echomap::exploration
