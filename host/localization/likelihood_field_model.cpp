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
    : map_(std::move(map)),
      field_(map_, params),
      origin_m_((map_.origin_m() - Eigen::Vector2d::Constant(map_.resolution_m())).cast<float>()),
      cells_per_m_(static_cast<float>(1.0 / map_.resolution_m())) {
  for (int y = -1; y <= map_.rows(); ++y) {
    for (int x = -1; x <= map_.columns(); ++x) {
      const bool is_floor = map_.state({x, y}) == mapping::CellState::kFree;
      floor_logs_.push_back(is_floor ? 0.0F : kLogOffFloor);
    }
  }
}

void LikelihoodFieldModel::observe(std::span<const RangeReading> readings) {
  readings_.clear();
  std::copy_if(readings.begin(),
               readings.end(),
               std::back_inserter(readings_),
               [](const RangeReading& reading) { return reading.range_m && is_usable(reading); });
}

void LikelihoodFieldModel::update_weights(float likelihood_exponent,
                                          ParticleRange range,
                                          Particles& particles) const {
  field_.update_weights(readings_, likelihood_exponent, range, particles);
  const auto columns = static_cast<std::size_t>(map_.columns()) + 2;
  const auto last_x = static_cast<float>(map_.columns()) + 1.5F;
  const auto last_y = static_cast<float>(map_.rows()) + 1.5F;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const float x = std::clamp((particles.x_m[i] - origin_m_.x()) * cells_per_m_, 0.0F, last_x);
    const float y = std::clamp((particles.y_m[i] - origin_m_.y()) * cells_per_m_, 0.0F, last_y);
    particles.log_weight[i] +=
        floor_logs_[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)];
  }
}

}  // namespace echomap::localization
