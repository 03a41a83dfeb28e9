// SPDX-License-Identifier: MIT
#include "host/localization/view_difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "host/geometry/unit_vector.hpp"
#include "host/localization/known_floor.hpp"
#include "host/mapping/ray_casting.hpp"

namespace echomap::localization {
namespace {

constexpr std::size_t kRays = 36;
constexpr float kMaxDifferenceM = 0.5F;
/// The rest is too improbable to be worth a way.
constexpr std::size_t kMaxPlaces = 8;

}  // namespace

ViewDifference::ViewDifference(const mapping::RasterMap& map, double max_range_m)
    : map_(with_unknown_ring(map)),
      surfaces_(map_, max_range_m),
      known_floor_(mapping::with_unknown_occupied(map_), max_range_m),
      max_range_m_(max_range_m) {}

/// By how much the floor that one place is known to have reaches beyond the surface of the other.
double ViewDifference::difference(const View& one, const View& other) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kRays; ++i) {
    float apart_m = 0.0F;
    for (const auto& [seen, beyond] : {std::pair(&one, &other), std::pair(&other, &one)}) {
      if (!leaves_known_floor(seen->floor_m[i], seen->surface_m[i])) {
        apart_m = std::max(apart_m, beyond->floor_m[i] - seen->surface_m[i]);
      }
    }
    sum += static_cast<double>(std::min(apart_m, kMaxDifferenceM));
  }
  return sum / (static_cast<double>(kMaxDifferenceM) * static_cast<double>(kRays));
}

ViewDifference::View ViewDifference::view_from(const geometry::Pose2& T_map_robot) const {
  std::vector<Eigen::Vector2f> directions;
  for (std::size_t i = 0; i < kRays; ++i) {
    const double bearing_rad = 2.0 * std::numbers::pi * static_cast<double>(i) / kRays;
    directions.emplace_back(
        geometry::unit_vector(T_map_robot.heading_rad() + bearing_rad).cast<float>());
  }
  View view{std::vector<float>(kRays, 0.0F),
            std::vector<float>(kRays, std::numeric_limits<float>::infinity())};
  const Eigen::Vector2d& from_m = T_map_robot.position_m();
  if (!map_.contains(map_.cell_at(from_m))) {
    return view;
  }
  mapping::cast_rays(known_floor_, from_m, directions, max_range_m_, view.floor_m);
  mapping::cast_rays(surfaces_, from_m, directions, max_range_m_, view.surface_m);
  return view;
}

double ViewDifference::telling(const std::vector<PoseHypothesis>& hypotheses,
                               const geometry::Pose2& T_robot_goal) const {
  const std::size_t count = std::min(hypotheses.size(), kMaxPlaces);
  std::vector<View> views;
  for (std::size_t i = 0; i < count; ++i) {
    views.push_back(view_from(hypotheses[i].T_map_robot * T_robot_goal));
  }
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const double weight = hypotheses[i].probability * hypotheses[j].probability;
      sum += weight * difference(views[i], views[j]);
      weights += weight;
    }
  }
  return weights > 0.0 ? sum / weights : 0.0;
}

}  // namespace echomap::localization
