// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/unit_vector.hpp"
#include "host/mapping/sonar_view.hpp"
#include "host/models/sonar_cone.hpp"

namespace echomap::mapping {

/// The cones of one view as a fan of fine rays, one cell apart at the sonar's maximum range: which
/// beams hold a point, and whether their sound gets there.
class SonarFan {
 public:
  /// A point of the fan.
  struct Place {
    std::size_t ray = 0;
    double range_m = 0.0;
  };

  /// `view` and `model` have to outlive the fan.
  SonarFan(const SonarView& view, const models::SonarCone& model, double resolution_m);

  /// Empty for a point outside of all cones or beyond the maximum range.
  std::optional<Place> place(const Eigen::Vector2d& point_m) const;
  /// Chance that the view would have missed an obstacle there: the beam that says most counts.
  double miss_chance(const Place& place) const;

  /// Follows all rays outwards; `opacity(point_m)` is the chance that a wall stands there.
  template <typename Opacity>
  void look(Opacity&& opacity) {
    for (std::size_t ray = 0; ray < beams_.size(); ++ray) {
      if (beams_[ray].empty()) {
        continue;
      }
      const Eigen::Vector2d way = geometry::unit_vector(bearing_rad(ray));
      double through = 1.0;
      for (std::size_t step = 0; step < steps_; ++step) {
        through_[ray * steps_ + step] = static_cast<float>(through);
        const double range_m = (static_cast<double>(step) + 0.5) * resolution_m_;
        through *= 1.0 - opacity(view_.origin_m + range_m * way);
      }
    }
  }
  /// Chance that nothing stands before the place, from `short_of_m` in front of it on; after
  /// look().
  double reached(const Place& place, double short_of_m) const;

 private:
  struct BeamOnRay {
    std::size_t beam = 0;
    double off_axis_rad = 0.0;
  };

  double bearing_rad(std::size_t ray) const { return static_cast<double>(ray) * spacing_rad_; }

  const SonarView& view_;
  const models::SonarCone& model_;
  double resolution_m_;
  double spacing_rad_;
  std::size_t steps_;
  std::vector<std::vector<BeamOnRay>> beams_;  ///< By ray.
  std::vector<float> through_;                 ///< By ray and step.
};

}  // namespace echomap::mapping
