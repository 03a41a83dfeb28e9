// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>

#include "host/localization/observation_model.hpp"
#include "host/localization/range_table.hpp"
#include "host/localization/range_update.hpp"

namespace echomap::localization {

/// Readings against the ranges that a RangeTable lets expect: for sonars, whose cone ends at the
/// first thing in it.
class RangeTableModel : public ObservationModel {
 public:
  template <models::RangeLikelihood Model>
  RangeTableModel(RangeTable table, const Model& model)
      : table_(std::move(table)), likelihoods_(table_, model) {}

  RangeTable& table() { return table_; }
  const mapping::RasterMap& map() const override { return table_.map(); }
  void observe(std::span<const RangeReading> readings) override;
  std::size_t count() const override { return readings_ ? readings_->count() : 0; }
  void make_ready(const Particles& particles, const Workers& workers) override;
  void update_weights(float likelihood_exponent,
                      ParticleRange range,
                      Particles& particles) const override;

 private:
  RangeTable table_;
  LikelihoodCodes likelihoods_;
  std::optional<CodedReadings> readings_;
};

}  // namespace echomap::localization
