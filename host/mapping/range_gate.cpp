// SPDX-License-Identifier: MIT
#include "host/mapping/range_gate.hpp"

#include <cmath>
#include <limits>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {

RangeGate::RangeGate(const std::vector<Sighting>& sightings, double tolerance_m)
    : tolerance_m_(tolerance_m), beyond_(sightings.size()) {
  for (const Sighting& sighting : sightings) {
    x_m_.push_back(sighting.center_m.x());
    y_m_.push_back(sighting.center_m.y());
    range_m_.push_back(sighting.surface.range_m);
  }
}

void RangeGate::close(std::size_t sighting) {
  range_m_[sighting] = std::numeric_limits<double>::quiet_NaN();
}

const std::vector<std::size_t>& RangeGate::passing(const EchoFeature& feature) {
  constexpr double kRounding = 1e-9;
  if (feature.kind == LandmarkKind::kWall) {
    measure_wall(feature);
  } else {
    measure_round(feature);
  }
  passing_.clear();
  for (std::size_t i = 0; i < beyond_.size(); ++i) {
    if (beyond_[i] <= kRounding) {
      passing_.push_back(i);
    }
  }
  return passing_;
}

void RangeGate::measure_wall(const EchoFeature& wall) {
  const Eigen::Vector2d normal = geometry::unit_vector(wall.value.y());
  for (std::size_t i = 0; i < beyond_.size(); ++i) {
    const double distance_m = wall.value.x() - normal.x() * x_m_[i] - normal.y() * y_m_[i];
    beyond_[i] = std::abs(distance_m - range_m_[i]) - tolerance_m_;
  }
}

/// Of a distance d to the middle and an expected one e, |d - e| <= t is |d^2 - e^2| <= t (d + e),
/// and d is at most e + t.
void RangeGate::measure_round(const EchoFeature& round) {
  for (std::size_t i = 0; i < beyond_.size(); ++i) {
    const double dx_m = round.value.x() - x_m_[i];
    const double dy_m = round.value.y() - y_m_[i];
    const double expected_m = range_m_[i] + round.radius_m;
    const double off_m2 = std::abs(dx_m * dx_m + dy_m * dy_m - expected_m * expected_m);
    beyond_[i] = off_m2 - tolerance_m_ * (2.0 * expected_m + tolerance_m_);
  }
}

}  // namespace echomap::mapping
