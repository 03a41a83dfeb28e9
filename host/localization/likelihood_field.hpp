// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "host/localization/observation_model.hpp"
#include "host/localization/particles.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::localization {

/// Settings of a LikelihoodField: those of AMCL but for the noise, 0.2 m there.
struct LikelihoodFieldParams {
  double hit_stddev_m = 0.15;   ///< How far from a wall a beam that hit it ends.
  double random_share = 0.05;   ///< Of beams that end anywhere.
  double max_distance_m = 2.0;  ///< What is farther from all walls is as far as that.
};

/// How likely a beam ends in each cell of a map, by the distance to the nearest wall (Thrun,
/// Burgard and Fox 2005, table 6.3): log of (1 - random) exp(-d^2 / 2 s^2) + random, so 0 at a
/// wall. Quick, but blind to what a beam passes through and to the width of a cone: for lasers.
class LikelihoodField {
 public:
  /// Throws std::invalid_argument for invalid settings.
  explicit LikelihoodField(const mapping::RasterMap& map, const LikelihoodFieldParams& params = {});

  double log_likelihood(const Eigen::Vector2d& end_m) const;

  /// Adds `temper` times the logarithm of the readings' likelihood to each particle's weight. A
  /// reading without return says nothing.
  void update_weights(std::span<const RangeReading> readings,
                      float likelihood_exponent,
                      ParticleRange range,
                      Particles& particles) const;

 private:
  double resolution_m_;
  Eigen::Vector2d origin_m_;
  std::int32_t columns_;
  std::int32_t rows_;
  std::vector<float> logs_;  ///< Row by row, within a ring of what lies beyond the map.
};

}  // namespace echomap::localization
