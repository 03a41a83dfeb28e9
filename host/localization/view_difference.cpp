// SPDX-License-Identifier: MIT
#include "host/localization/view_difference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/geometry/unit_vector.hpp"
#include "host/mapping/ray_casting.hpp"

namespace echomap::localization {
namespace {

constexpr std::size_t kRays = 36;
constexpr float kMaxDifferenceM = 0.5F;
/// The rest is too improbable to be worth a way.
constexpr std::size_t kMaxPlaces = 8;

double difference(const std::vector<float>& one, const std::vector<float>& other) {
  double sum = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    sum += static_cast<double>(std::min(std::abs(one[i] - other[i]), kMaxDifferenceM));
  }
  return sum / (static_cast<double>(kMaxDifferenceM) * static_cast<double>(one.size()));
}

}  // namespace

ViewDifference::ViewDifference(const mapping::RasterMap& map, double max_range_m)
    : field_(map, max_range_m), max_range_m_(max_range_m) {}

std::vector<float> ViewDifference::view_from(const geometry::Pose2& T_map_robot) const {
  std::vector<Eigen::Vector2f> directions;
  for (std::size_t i = 0; i < kRays; ++i) {
    const double bearing_rad = 2.0 * std::numbers::pi * static_cast<double>(i) / kRays;
    directions.emplace_back(
        geometry::unit_vector(T_map_robot.heading_rad() + bearing_rad).cast<float>());
  }
  std::vector<float> ranges_m(kRays);
  mapping::cast_rays(field_, T_map_robot.position_m(), directions, max_range_m_, ranges_m);
  return ranges_m;
}

double ViewDifference::telling(const std::vector<PoseHypothesis>& hypotheses,
                               const geometry::Pose2& T_robot_goal) const {
  const std::size_t count = std::min(hypotheses.size(), kMaxPlaces);
  std::vector<std::vector<float>> views;
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
