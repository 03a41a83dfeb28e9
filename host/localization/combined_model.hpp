// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "host/localization/observation_model.hpp"

namespace echomap::localization {

/// The product of the likelihoods of several models, each of another sensor of one robot.
class CombinedModel : public ObservationModel {
 public:
  /// All are of the same map, in the frame of the first. Throws std::invalid_argument for none.
  explicit CombinedModel(std::vector<std::unique_ptr<ObservationModel>> models);

  const mapping::RasterMap& map() const override { return models_.front()->map(); }
  void add_contact(const models::ContactReading& reading) override;
  void observe(std::span<const RangeReading> readings) override;
  std::size_t count() const override;
  void make_ready(const Particles& particles, const Workers& workers) override;
  void update_weights(float likelihood_exponent,
                      ParticleRange range,
                      Particles& particles) const override;

 private:
  std::vector<std::unique_ptr<ObservationModel>> models_;
};

}  // namespace echomap::localization
