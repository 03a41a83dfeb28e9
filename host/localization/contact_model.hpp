// SPDX-License-Identifier: MIT
#pragma once

#include "host/localization/observation_model.hpp"
#include "host/localization/polygon_view.hpp"
#include "host/models/contact_likelihood.hpp"

namespace echomap::localization {

/// A robot that only feels its walls, in the outline of its room (Mukherjee et al., section V): a
/// particle outside of it is rejected, the others are weighed by bumper and virtual wall. Ranges
/// say nothing.
class ContactModel : public ObservationModel {
 public:
  /// `radius_m` is that of the robot's body. Throws std::invalid_argument where it is not above 0,
  /// and where the map's floor has no cell of 5 cm.
  ContactModel(const mapping::PolygonMap& map,
               double radius_m,
               const models::ContactParams& params = {});

  void add_contact(const models::ContactReading& reading) override { reading_ = reading; }

  const mapping::RasterMap& map() const override { return floor_; }
  void observe(std::span<const RangeReading> /*readings*/) override {}
  /// That the robot is inside always says something.
  std::size_t count() const override { return 1; }
  void make_ready(const Particles& /*particles*/, const Workers& /*workers*/) override {}
  void update_weights(float likelihood_exponent,
                      ParticleRange range,
                      Particles& particles) const override;

 private:
  PolygonView view_;
  mapping::RasterMap floor_;
  double radius_m_;
  models::ContactLikelihood likelihood_;
  models::ContactReading reading_;
};

}  // namespace echomap::localization
