// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/scan_check.hpp"

namespace echomap::mapping {

/// What a map has on the arc of an echo, as wide as the beam and as deep as its tolerance
/// (ScanCheckParams); counted in places half a cell apart.
struct EchoArc {
  std::size_t places = 0;
  std::size_t occupied = 0;
  std::size_t unknown = 0;
  std::size_t firm_floor = 0;

  bool is_floor() const { return occupied == 0 && unknown == 0; }
  /// Whether at most such a share of it is other than firm floor, and nothing stands there.
  bool is_firm_floor(double max_other_share) const {
    return occupied == 0 && static_cast<double>(places - firm_floor) <=
                                max_other_share * static_cast<double>(places);
  }
};

/// Of a reading with an echo, placed on the map.
EchoArc arc_of(const PlacedReading& reading,
               const OccupancyGrid& map,
               const ScanCheckParams& params);

}  // namespace echomap::mapping
