// SPDX-License-Identifier: MIT
#include "host/geometry/straight_corners.hpp"

#include <cstddef>

#include "host/geometry/segment.hpp"

namespace echomap::geometry {

Polygon without_straight_corners(Polygon ring_m, double tolerance_m) {
  std::size_t checked = 0;
  for (std::size_t i = 0; ring_m.size() > 3 && checked < ring_m.size();) {
    i %= ring_m.size();
    const Segment between{ring_m[(i + ring_m.size() - 1) % ring_m.size()],
                          ring_m[(i + 1) % ring_m.size()]};
    if (distance_m(between, ring_m[i]) <= tolerance_m) {
      ring_m.erase(ring_m.begin() + static_cast<std::ptrdiff_t>(i));
      i += ring_m.size() - 1;
      checked = 0;
    } else {
      ++i;
      ++checked;
    }
  }
  return ring_m;
}

}  // namespace echomap::geometry
