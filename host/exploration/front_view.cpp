// SPDX-License-Identifier: MIT
#include "host/exploration/front_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::exploration {

namespace {

Eigen::Vector2d place_m(const ViewedRange& seen) {
  return seen.range_m * geometry::unit_vector(seen.bearing_rad);
}

/// An opening begins where the view falls back to the left, and ends where it comes forward again.
void measure_openings(std::vector<Discontinuity>& all) {
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (all[i].free_side != 1 || all[i + 1].free_side != -1) {
      continue;
    }
    const double width_m = (place_m(all[i].near) - place_m(all[i + 1].near)).norm();
    all[i].width_m = width_m;
    all[i + 1].width_m = width_m;
  }
}

}  // namespace

std::vector<ViewedRange> front_view(const mapping::Scan& scan,
                                    const geometry::Pose2& T_map_robot,
                                    double goal_bearing_map_rad,
                                    double half_view_rad,
                                    double max_m) {
  std::vector<ViewedRange> view;
  for (const mapping::PlacedReading& reading : scan) {
    const Eigen::Vector2d offset_m =
        reading.T_map_sonar * Eigen::Vector2d(reading.range_m.value_or(max_m), 0.0) -
        T_map_robot.position_m();
    const double bearing_rad =
        geometry::angle_between(goal_bearing_map_rad, std::atan2(offset_m.y(), offset_m.x()));
    if (std::abs(bearing_rad) <= half_view_rad) {
      view.push_back({bearing_rad, offset_m.norm()});
    }
  }
  std::stable_sort(view.begin(), view.end(), [](const auto& one, const auto& other) {
    return one.bearing_rad < other.bearing_rad;
  });
  return view;
}

std::vector<Discontinuity> discontinuities(const std::vector<ViewedRange>& view, double jump_m) {
  std::vector<Discontinuity> all;
  for (std::size_t i = 0; i + 1 < view.size(); ++i) {
    const double jump_to_left_m = view[i + 1].range_m - view[i].range_m;
    if (std::abs(jump_to_left_m) > jump_m) {
      const bool falls_back = jump_to_left_m > 0.0;
      all.push_back({view[falls_back ? i : i + 1],
                     falls_back ? 1 : -1,
                     std::numeric_limits<double>::infinity()});
    }
  }
  measure_openings(all);
  return all;
}

}  // namespace echomap::exploration
