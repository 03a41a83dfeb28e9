// SPDX-License-Identifier: MIT
#include "host/localization/combined_model.hpp"

#include <stdexcept>
#include <utility>

namespace echomap::localization {

CombinedModel::CombinedModel(std::vector<std::unique_ptr<ObservationModel>> models)
    : models_(std::move(models)) {
  if (models_.empty()) {
    throw std::invalid_argument("combined model: it is of no model");
  }
}

void CombinedModel::add_contact(const models::ContactReading& reading) {
  for (const auto& model : models_) {
    model->add_contact(reading);
  }
}

void CombinedModel::observe(std::span<const RangeReading> readings) {
  for (const auto& model : models_) {
    model->observe(readings);
  }
}

std::size_t CombinedModel::count() const {
  std::size_t count = 0;
  for (const auto& model : models_) {
    count += model->count();
  }
  return count;
}

void CombinedModel::make_ready(const Particles& particles, const Workers& workers) {
  for (const auto& model : models_) {
    model->make_ready(particles, workers);
  }
}

void CombinedModel::update_weights(float likelihood_exponent,
                                   ParticleRange range,
                                   Particles& particles) const {
  for (const auto& model : models_) {
    model->update_weights(likelihood_exponent, range, particles);
  }
}

}  // namespace echomap::localization
