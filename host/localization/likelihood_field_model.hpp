// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/localization/likelihood_field.hpp"
#include "host/localization/observation_model.hpp"

namespace echomap::localization {

/// Readings against a LikelihoodField: for lasers. It holds for walls that are drawn too thick,
/// which end a cast ray too soon.
class LikelihoodFieldModel : public ObservationModel {
 public:
  /// Throws std::invalid_argument for invalid settings.
  explicit LikelihoodFieldModel(mapping::RasterMap map, const LikelihoodFieldParams& params = {});

  const mapping::RasterMap& map() const override { return map_; }
  void observe(std::span<const RangeReading> readings) override;
  std::size_t count() const override { return readings_.size(); }
  void make_ready(const Particles& /*particles*/, const Workers& /*workers*/) override {}
  /// A pose that is not on free floor loses 8 more than its readings say.
  void update_weights(float likelihood_exponent,
                      ParticleRange range,
                      Particles& particles) const override;

 private:
  mapping::RasterMap map_;
  LikelihoodField field_;
  Eigen::Vector2f origin_m_;  ///< Of a ring around the map.
  float cells_per_m_;
  std::vector<float> floor_logs_;       ///< Of each cell with the ring, row by row.
  std::vector<RangeReading> readings_;  ///< Those that say something.
};

}  // namespace echomap::localization
