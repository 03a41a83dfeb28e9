// SPDX-License-Identifier: MIT
#include "host/mapping/scan_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/geometry/segment.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {

ScanOutline::ScanOutline(const ScanSurfaces& scan, double max_gap_rad) : max_gap_rad_(max_gap_rad) {
  for (const auto& surface : scan.surfaces) {
    const Eigen::Vector2d normal = geometry::unit_vector(surface.bearing_rad);
    const Eigen::Vector2d along = geometry::perpendicular(normal);
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector2d place_m =
          surface.range_m * normal + side * surface.half_length_m * along;
      corners_.push_back({std::atan2(place_m.y(), place_m.x()), place_m});
    }
  }
  std::sort(corners_.begin(), corners_.end(), [](const Corner& a, const Corner& b) {
    return a.bearing_rad < b.bearing_rad;
  });
}

double ScanOutline::range_m(double bearing_rad) const {
  if (corners_.empty()) {
    return 0.0;
  }
  const auto is_before = [](double bearing, const Corner& corner) {
    return bearing < corner.bearing_rad;
  };
  const auto next = std::upper_bound(corners_.begin(), corners_.end(), bearing_rad, is_before);
  const Corner& to = next == corners_.end() ? corners_.front() : *next;
  const Corner& from = next == corners_.begin() ? corners_.back() : *(next - 1);
  double gap_rad = to.bearing_rad - from.bearing_rad;
  gap_rad += gap_rad <= 0.0 ? 2.0 * std::numbers::pi : 0.0;
  if (gap_rad > max_gap_rad_) {
    return 0.0;
  }
  const Eigen::Vector2d border_m = to.place_m - from.place_m;
  const double slant = geometry::cross(geometry::unit_vector(bearing_rad), border_m);
  constexpr double kAlongTheBorder = 1e-9;
  return slant < kAlongTheBorder ? std::min(from.place_m.norm(), to.place_m.norm())
                                 : geometry::cross(from.place_m, border_m) / slant;
}

double ScanOutline::max_m() const {
  double max_m = 0.0;
  for (const Corner& corner : corners_) {
    max_m = std::max(max_m, corner.place_m.norm());
  }
  return max_m;
}

}  // namespace echomap::mapping
