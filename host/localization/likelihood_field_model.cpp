// SPDX-License-Identifier: MIT
#include "host/localization/likelihood_field_model.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "host/localization/usable_reading.hpp"

namespace echomap::localization {

namespace {

constexpr float kLogOffFloor = -8.0F;

}  // namespace

LikelihoodFieldModel::LikelihoodFieldModel(mapping::RasterMap map,
                                           const LikelihoodFieldParams& params)
    : map_(std::move(map)), field_(map_, params) {}

void LikelihoodFieldModel::observe(std::span<const RangeReading> readings) {
  readings_.clear();
  std::copy_if(readings.begin(),
               readings.end(),
               std::back_inserter(readings_),
               [](const RangeReading& reading) { return reading.range_m && is_usable(reading); });
}

void LikelihoodFieldModel::weigh(float temper, ParticleRange range, Particles& particles) const {
  field_.weigh(readings_, temper, range, particles);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const Eigen::Vector2d place_m(particles.x_m[i], particles.y_m[i]);
    if (map_.state(map_.cell_at(place_m)) != mapping::CellState::kFree) {
      particles.log_weight[i] += kLogOffFloor;
    }
  }
}

}  // namespace echomap::localization
