// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "host/mapping/placed_reading.hpp"

namespace echomap::exploration {

/// When two scans are taken for views from one place; ours.
struct SameViewParams {
  /// Readings closer than this in bearing are compared: half a usual step of the pan.
  double bearing_rad = 0.0524;
  /// Ranges are the same within this: two sigma of the difference of two readings.
  double range_m = 0.09;
  /// Fewer pairs tell nothing.
  std::size_t min_pairs = 16;
  /// Share of the pairs that have to be the same.
  double share = 0.85;
};

/// Whether two scans have heard the same ranges at the same bearings of the map, or off the body,
/// as where wheels slip that should have turned it. A robot that has moved by some tenths of a
/// metre hears others, unless it stands in a passage without ends.
bool is_same_view(const mapping::Scan& one,
                  const mapping::Scan& other,
                  const SameViewParams& params = {});

}  // namespace echomap::exploration
