// SPDX-License-Identifier: MIT
#include "host/mapping/feature_contradiction.hpp"

#include <algorithm>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

/// Between two feet farther apart there is room for a door.
constexpr double kMaxFeetApartM = 1.5;

/// Whether a foot at `at_m` lies between two neighbours of those that were heard.
bool is_between(double at_m, const std::vector<double>& feet_m) {
  const auto next = std::lower_bound(feet_m.begin(), feet_m.end(), at_m);
  return next != feet_m.begin() && next != feet_m.end() && *next - *(next - 1) <= kMaxFeetApartM;
}

}  // namespace

FeatureContradiction::FeatureContradiction(const std::vector<ScanSurfaces>& scans,
                                           const std::vector<bool>& among,
                                           const SurfaceMatchingParams& params)
    : beyond_m_(params.contradiction_m), max_range_m_(params.contradiction_range_m) {
  for (std::size_t i = 0; i < scans.size() && params.contradiction_weight > 0.0; ++i) {
    if (among[i]) {
      stops_.push_back({i,
                        scans[i].center_m,
                        heard_within(scans[i].looks, params.contradiction_half_angle_rad)});
    }
  }
}

std::size_t FeatureContradiction::count(const EchoFeature& feature,
                                        const std::vector<Sighting>& supporters) const {
  const bool is_wall = feature.kind == LandmarkKind::kWall;
  const Eigen::Vector2d along = geometry::perpendicular(geometry::unit_vector(feature.value.y()));
  std::vector<double> feet_m;
  feet_m.reserve(supporters.size());
  for (const Sighting& sighting : supporters) {
    feet_m.push_back(along.dot(sighting.center_m));
  }
  std::sort(feet_m.begin(), feet_m.end());
  const auto is_against = [&](const Stop& stop) {
    const bool supports = std::any_of(supporters.begin(), supporters.end(), [&](const auto& one) {
      return one.scan == stop.scan;
    });
    return !supports && (!is_wall || is_between(along.dot(stop.center_m), feet_m)) &&
           contradicts(stop, feature);
  };
  return static_cast<std::size_t>(std::count_if(stops_.begin(), stops_.end(), is_against));
}

bool FeatureContradiction::contradicts(const Stop& stop, const EchoFeature& feature) const {
  const FeatureView view = view_from(stop.center_m, feature);
  return view.range_m > 0.0 && view.range_m <= max_range_m_ &&
         stop.heard_m[BearingProfile::index(view.bearing_rad)] > view.range_m + beyond_m_;
}

}  // namespace echomap::mapping
