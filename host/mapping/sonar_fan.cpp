// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_fan.hpp"

#include <numbers>
#include <numeric>

#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {

namespace {

constexpr double kTurnRad = 2.0 * std::numbers::pi;

}  // namespace

FanRays::FanRays(double max_range_m, double resolution_m)
    : resolution_m_(resolution_m),
      count_(static_cast<std::size_t>(std::ceil(kTurnRad * max_range_m / resolution_m))),
      steps_(static_cast<std::size_t>(max_range_m / resolution_m) + 2),
      spacing_rad_(kTurnRad / static_cast<double>(count_)) {
  directions_.reserve(count_);
  for (std::size_t ray = 0; ray < count_; ++ray) {
    directions_.push_back(geometry::unit_vector(static_cast<double>(ray) * spacing_rad_));
  }
}

SonarFan::SonarFan(const SonarView& view, const models::SonarCone& model, const FanRays& rays)
    : view_(view),
      rays_(rays),
      max_range_m_(model.params().max_range_m),
      first_on_ray_(rays.count() + 1, 0),
      free_to_m_(rays.count(), 0.0),
      through_(rays.count() * rays.steps(), 0.0F) {
  put_beams_on_rays(model);
  find_sectors(model);
}

template <typename Visitor>
void SonarFan::for_beams_on_rays(const models::SonarCone& model, Visitor&& visit) const {
  const double beam_half_angle_rad = model.params().beam_half_angle_rad;
  const double spacing_rad = rays_.spacing_rad();
  const auto count = static_cast<std::int64_t>(rays_.count());
  for (const sensors::Beam& beam : view_.beams) {
    const auto first = static_cast<std::int64_t>(
        std::ceil((beam.bearing_rad - beam_half_angle_rad) / spacing_rad));
    const auto last = static_cast<std::int64_t>(
        std::floor((beam.bearing_rad + beam_half_angle_rad) / spacing_rad));
    for (std::int64_t i = first; i <= last; ++i) {
      visit(beam,
            static_cast<std::size_t>((i % count + count) % count),
            static_cast<double>(i) * spacing_rad - beam.bearing_rad);
    }
  }
}

void SonarFan::put_beams_on_rays(const models::SonarCone& model) {
  for_beams_on_rays(
      model, [this](const sensors::Beam&, std::size_t ray, double) { ++first_on_ray_[ray + 1]; });
  std::partial_sum(first_on_ray_.begin(), first_on_ray_.end(), first_on_ray_.begin());
  on_ray_.resize(first_on_ray_.back());
  std::vector<std::uint32_t> next(first_on_ray_.begin(), first_on_ray_.end() - 1);
  for_beams_on_rays(model, [&](const sensors::Beam& beam, std::size_t ray, double off_axis_rad) {
    const models::SensorReading reading{beam.range_m};
    const double free_to_m = model.free_to_m(reading);
    on_ray_[next[ray]++] = {free_to_m, model.miss_chance(reading, {0.0, off_axis_rad})};
    free_to_m_[ray] = std::max(free_to_m_[ray], free_to_m);
  });
}

void SonarFan::find_sectors(const models::SonarCone& model) {
  const std::size_t count = rays_.count();
  const auto is_held = [this, count](std::size_t ray) {
    return first_on_ray_[ray % count] < first_on_ray_[ray % count + 1];
  };
  std::size_t begin = 0;
  while (begin < count && is_held(begin)) {
    ++begin;
  }
  for (std::size_t i = begin; i < begin + count; ++i) {
    if (!is_held(i)) {
      continue;
    }
    if (sectors_.empty() || !is_held(i + count - 1)) {
      sectors_.push_back({i % count});
    }
    widen(sectors_.back(), i % count);
  }
  const double to_arc_m = model.params().free_margin_m + model.params().arc_half_thickness_m;
  for (Sector& sector : sectors_) {
    const auto steps = static_cast<std::size_t>((sector.reach_m + to_arc_m) / rays_.step_m()) + 2;
    sector.steps = std::min(steps, rays_.steps());
  }
}

void SonarFan::widen(Sector& sector, std::size_t ray) const {
  const Eigen::Array2d end_m = free_to_m_[ray] * rays_.direction(ray);
  const double beside_m = rays_.step_m();
  ++sector.rays;
  sector.reach_m = std::max(sector.reach_m, free_to_m_[ray]);
  sector.low_m = sector.low_m.min(end_m - beside_m);
  sector.high_m = sector.high_m.max(end_m + beside_m);
}

std::optional<SonarFan::Place> SonarFan::place(const Eigen::Vector2d& point_m) const {
  const Eigen::Vector2d offset_m = point_m - view_.origin_m;
  const Place place{ray_towards(offset_m), offset_m.norm()};
  const bool is_held = first_on_ray_[place.ray] < first_on_ray_[place.ray + 1];
  return is_held && place.range_m <= max_range_m_ ? std::optional(place) : std::nullopt;
}

double SonarFan::miss_chance(const Place& place) const {
  double least = 1.0;
  for (std::uint32_t i = first_on_ray_[place.ray]; i < first_on_ray_[place.ray + 1]; ++i) {
    if (place.range_m < on_ray_[i].free_to_m) {
      least = std::min(least, on_ray_[i].miss_chance);
    }
  }
  return least;
}

}  // namespace echomap::mapping
