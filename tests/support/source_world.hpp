// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/raster_map.hpp"
#include "host/source_search/field_model.hpp"

namespace echomap::tests {

/// Something solid, upright.
struct SolidBox {
  Eigen::Vector2d low_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d high_m = Eigen::Vector2d::Zero();

  bool contains(const Eigen::Vector2d& point_m) const {
    return (point_m.array() > low_m.array()).all() && (point_m.array() < high_m.array()).all();
  }
};

/// What there truly is to be found.
struct SourceTruth {
  std::optional<Eigen::Vector2d> at_m;  ///< Empty for none.
  double strength = 5.0;                ///< Pulses a second in a distance of 1 m.
  double background = 0.4;              ///< Pulses a second.
  double attenuation_per_m = 6.0;
  /// The background is so much larger in one corner than in the middle, and so much smaller in the
  /// opposite one.
  double background_slope = 0.0;
};

/// A floor with a map that is right, and a source on it: rates by geometry, not by the map.
class SourceWorld {
 public:
  /// A rectangle from (0, 0) within walls, with boxes in it.
  SourceWorld(const Eigen::Vector2d& size_m, std::vector<SolidBox> boxes);

  const mapping::RasterMap& map() const { return map_; }
  const Eigen::Vector2d& size_m() const { return size_m_; }
  /// Off walls and boxes by so much.
  bool is_free(const Eigen::Vector2d& point_m, double clearance_m) const;
  /// A place that is.
  Eigen::Vector2d sample_free(double clearance_m, std::mt19937& random) const;
  double solid_m(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const;
  /// Pulses a second, with a standoff of `standoff_m`.
  double rate(const SourceTruth& truth, const Eigen::Vector2d& at_m, double standoff_m) const;

 private:
  Eigen::Vector2d size_m_;
  std::vector<SolidBox> boxes_;  ///< Walls around among them.
  mapping::RasterMap map_;
};

/// 16 x 12 m with six crates in it.
SourceWorld open_hall();
/// 14 x 10 m: a corridor with three rooms to both sides, and brick walls of 20 cm between.
SourceWorld shielding_rooms();

/// A Poisson number.
double sample_poisson(double mean, std::mt19937& random);

}  // namespace echomap::tests
