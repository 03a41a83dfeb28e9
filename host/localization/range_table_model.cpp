// SPDX-License-Identifier: MIT
#include "host/localization/range_table_model.hpp"

namespace echomap::localization {

void RangeTableModel::observe(std::span<const RangeReading> readings) {
  readings_.emplace(readings, table_, likelihoods_);
}

void RangeTableModel::make_ready(const Particles& particles, const Workers& workers) {
  if (readings_) {
    fill_under(particles, *readings_, table_, workers);
  }
}

void RangeTableModel::update_weights(float likelihood_exponent,
                                     ParticleRange range,
                                     Particles& particles) const {
  if (readings_) {
    localization::update_weights(table_, *readings_, likelihood_exponent, range, particles);
  }
}

}  // namespace echomap::localization
