// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {

namespace {

/// Readings closer together than this look in one direction.
constexpr double kSameDirectionRad = geometry::radians(1.0);

double range_or_far_m(const sensors::Beam& beam) {
  return beam.range_m.value_or(std::numeric_limits<double>::infinity());
}

std::vector<sensors::Beam> without_repeats(std::vector<sensors::Beam> beams) {
  std::sort(beams.begin(), beams.end(), [](const auto& a, const auto& b) {
    return a.bearing_rad < b.bearing_rad;
  });
  std::vector<sensors::Beam> once;
  for (auto first = beams.begin(); first != beams.end();) {
    const auto last = std::find_if(first, beams.end(), [&](const sensors::Beam& beam) {
      return beam.bearing_rad > first->bearing_rad + kSameDirectionRad;
    });
    const auto middle = first + (last - first) / 2;
    const double bearing_rad = middle->bearing_rad;
    std::nth_element(first, middle, last, [](const auto& a, const auto& b) {
      return range_or_far_m(a) < range_or_far_m(b);
    });
    once.push_back({bearing_rad, middle->range_m});
    first = last;
  }
  return once;
}

}  // namespace

std::vector<SonarView> views_of(const Scan& scan, double same_place_m) {
  std::vector<SonarView> views;
  for (const PlacedReading& reading : scan) {
    const Eigen::Vector2d& origin_m = reading.T_map_sonar.position_m();
    if (views.empty() || (origin_m - views.back().origin_m).norm() > same_place_m) {
      views.push_back({origin_m, {}, reading.T_map_robot.position_m()});
    }
    views.back().beams.push_back({reading.T_map_sonar.heading_rad(), reading.range_m});
  }
  for (SonarView& view : views) {
    view.beams = without_repeats(std::move(view.beams));
  }
  return views;
}

}  // namespace echomap::mapping
