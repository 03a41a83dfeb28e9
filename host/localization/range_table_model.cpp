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

void RangeTableModel::weigh(float temper, ParticleRange range, Particles& particles) const {
  if (readings_) {
    localization::weigh(table_, *readings_, temper, range, particles);
  }
}

}  // namespace echomap::localization
