// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/cell_field.hpp"
#include "host/mapping/sonar_view.hpp"
#include "host/models/sonar_cone.hpp"

namespace echomap::mapping {

/// The fine rays that all fans of one sonar are made of: a full turn, one cell apart at the sonar's
/// maximum range, in steps of one cell.
class FanRays {
 public:
  FanRays(double max_range_m, double resolution_m);

  std::size_t count() const { return count_; }
  std::size_t steps() const { return steps_; }
  double spacing_rad() const { return spacing_rad_; }
  double step_m() const { return resolution_m_; }
  /// The unit vector along a ray.
  const Eigen::Vector2d& direction(std::size_t ray) const { return directions_[ray]; }

  /// The ray nearest to a bearing in (-pi, pi].
  std::size_t ray_at(double bearing_rad) const {
    const auto turned =
        static_cast<std::size_t>(bearing_rad / spacing_rad_ + 0.5 + static_cast<double>(count_));
    return turned >= count_ ? turned - count_ : turned;
  }
  /// Of a step of a ray, among all steps of all rays.
  std::uint32_t index(std::size_t ray, double range_m) const {
    const auto step = static_cast<std::size_t>(std::max(0.0, range_m) / resolution_m_);
    return static_cast<std::uint32_t>(ray * steps_ + std::min(step, steps_ - 1));
  }

 private:
  double resolution_m_;
  std::size_t count_;
  std::size_t steps_;
  double spacing_rad_;
  std::vector<Eigen::Vector2d> directions_;
};

/// The cones of one view as a fan of fine rays: which beams hold a point, what they say of it, and
/// whether their sound gets there.
class SonarFan {
 public:
  /// A point of the fan.
  struct Place {
    std::size_t ray = 0;
    double range_m = 0.0;
  };

  /// `view` and `rays` have to outlive the fan.
  SonarFan(const SonarView& view, const models::SonarCone& model, const FanRays& rays);

  /// Empty for a point outside of all cones or beyond the maximum range.
  std::optional<Place> place(const Eigen::Vector2d& point_m) const;
  /// Chance that the view would have missed an obstacle there: the beam that says most counts.
  double miss_chance(const Place& place) const;

  /// Follows all rays outwards; `opacity(point_m)` is the chance that a wall stands there.
  template <typename Opacity>
  void look(Opacity&& opacity) {
    for (const Sector& sector : sectors_) {
      for (std::size_t i = 0; i < sector.rays; ++i) {
        const std::size_t ray = (sector.first_ray + i) % rays_.count();
        const Eigen::Vector2d& direction = rays_.direction(ray);
        float through = 1.0F;
        for (std::size_t step = 0; step < sector.steps; ++step) {
          through_[ray * rays_.steps() + step] = through;
          const double range_m = (static_cast<double>(step) + 0.5) * rays_.step_m();
          through *= 1.0F - static_cast<float>(opacity(view_.origin_m + range_m * direction));
        }
      }
    }
  }
  /// Chance that nothing stands before the place, from `short_of_m` in front of it on; after
  /// look().
  float reached(const Place& place, double short_of_m) const {
    return reached(rays_.index(place.ray, place.range_m - short_of_m));
  }
  /// The same by the step's index; nothing gets to where no cone is.
  float reached(std::uint32_t index) const { return through_[index]; }

  /// Calls `visit(cell, place)` once for each cell whose centre the view says something of.
  template <typename Visitor>
  void for_cells(const CellField& field, Visitor&& visit) const {
    const auto visit_cell = [&](const Sector& sector, geometry::CellIndex cell) {
      if (const auto place = place_in(sector, field.center_m(cell) - view_.origin_m)) {
        visit(cell, *place);
      }
    };
    for (const Sector& sector : sectors_) {
      const auto low = field.cell_at(view_.origin_m.array() + sector.low_m);
      const auto high = field.cell_at(view_.origin_m.array() + sector.high_m);
      for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) {
          visit_cell(sector, {x, y});
        }
      }
    }
  }

 private:
  /// What one beam says along one ray.
  struct BeamOnRay {
    double free_to_m = 0.0;
    double miss_chance = 1.0;
  };
  /// Neighbouring rays that hold beams.
  struct Sector {
    std::size_t first_ray = 0;
    std::size_t rays = 0;
    std::size_t steps = 0;  ///< To beyond the arcs.
    double reach_m = 0.0;   ///< Nothing is said of what is as far as this.
    Eigen::Array2d low_m = Eigen::Array2d::Zero();
    Eigen::Array2d high_m = Eigen::Array2d::Zero();
  };

  /// Calls `visit(beam, ray, off_axis_rad)` for all rays of all cones.
  template <typename Visitor>
  void for_beams_on_rays(const models::SonarCone& model, Visitor&& visit) const;
  void put_beams_on_rays(const models::SonarCone& model);
  void find_sectors(const models::SonarCone& model);
  void widen(Sector& sector, std::size_t ray) const;
  std::size_t ray_towards(const Eigen::Vector2d& offset_m) const {
    return rays_.ray_at(
        std::atan2(static_cast<float>(offset_m.y()), static_cast<float>(offset_m.x())));
  }
  /// Empty where the sector's beams say nothing.
  std::optional<Place> place_in(const Sector& sector, const Eigen::Vector2d& offset_m) const {
    const double square_m2 = offset_m.squaredNorm();
    if (square_m2 >= sector.reach_m * sector.reach_m) {
      return std::nullopt;
    }
    const Place place{ray_towards(offset_m), std::sqrt(square_m2)};
    const bool says_something = holds(sector, place.ray) && place.range_m < free_to_m_[place.ray];
    return says_something ? std::optional(place) : std::nullopt;
  }
  bool holds(const Sector& sector, std::size_t ray) const {
    const std::size_t after = ray + (ray < sector.first_ray ? rays_.count() : 0);
    return after - sector.first_ray < sector.rays;
  }

  const SonarView& view_;
  const FanRays& rays_;
  double max_range_m_;
  std::vector<Sector> sectors_;
  std::vector<std::uint32_t> first_on_ray_;  ///< By ray, and one for the end: into on_ray_.
  std::vector<BeamOnRay> on_ray_;
  std::vector<double> free_to_m_;  ///< By ray.
  std::vector<float> through_;     ///< By ray and step.
};

}  // namespace echomap::mapping
