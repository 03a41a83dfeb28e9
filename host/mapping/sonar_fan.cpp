// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_fan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {

namespace {

constexpr double kTurnRad = 2.0 * std::numbers::pi;

std::size_t ray_count(double max_range_m, double resolution_m) {
  return static_cast<std::size_t>(std::ceil(kTurnRad * max_range_m / resolution_m));
}

}  // namespace

SonarFan::SonarFan(const SonarView& view, const models::SonarCone& model, double resolution_m)
    : view_(view),
      model_(model),
      resolution_m_(resolution_m),
      spacing_rad_(kTurnRad /
                   static_cast<double>(ray_count(model.params().max_range_m, resolution_m))),
      steps_(static_cast<std::size_t>(model.params().max_range_m / resolution_m) + 2),
      beams_(ray_count(model.params().max_range_m, resolution_m)),
      through_(beams_.size() * steps_, 1.0F) {
  const double half_angle_rad = model.params().half_angle_rad;
  const auto rays = static_cast<std::int64_t>(beams_.size());
  for (std::size_t beam = 0; beam < view.beams.size(); ++beam) {
    const double axis_rad = view.beams[beam].bearing_rad;
    const auto first =
        static_cast<std::int64_t>(std::ceil((axis_rad - half_angle_rad) / spacing_rad_));
    const auto last =
        static_cast<std::int64_t>(std::floor((axis_rad + half_angle_rad) / spacing_rad_));
    for (std::int64_t i = first; i <= last; ++i) {
      const auto ray = static_cast<std::size_t>((i % rays + rays) % rays);
      beams_[ray].push_back({beam, static_cast<double>(i) * spacing_rad_ - axis_rad});
    }
  }
}

std::optional<SonarFan::Place> SonarFan::place(const Eigen::Vector2d& point_m) const {
  const Eigen::Vector2d way_m = point_m - view_.origin_m;
  const double range_m = way_m.norm();
  if (range_m > model_.params().max_range_m) {
    return std::nullopt;
  }
  const double bearing_rad = std::atan2(way_m.y(), way_m.x());
  const double turned_rad = bearing_rad < 0.0 ? bearing_rad + kTurnRad : bearing_rad;
  const auto ray = static_cast<std::size_t>(std::lround(turned_rad / spacing_rad_)) % beams_.size();
  if (beams_[ray].empty()) {
    return std::nullopt;
  }
  return Place{ray, range_m};
}

double SonarFan::miss_chance(const Place& place) const {
  double least = 1.0;
  for (const BeamOnRay& on_ray : beams_[place.ray]) {
    least = std::min(least,
                     model_.miss_chance({view_.beams[on_ray.beam].range_m},
                                        {place.range_m, on_ray.off_axis_rad}));
  }
  return least;
}

double SonarFan::reached(const Place& place, double short_of_m) const {
  const double range_m = std::max(0.0, place.range_m - short_of_m);
  const auto step = static_cast<std::size_t>(range_m / resolution_m_);
  return through_[place.ray * steps_ + std::min(step, steps_ - 1)];
}

}  // namespace echomap::mapping
