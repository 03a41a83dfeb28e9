// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/localization/observation_model.hpp"
#include "host/models/map_correlation.hpp"
#include "host/models/occupied_sector.hpp"

namespace echomap::localization {

/// How a look around becomes a local map.
struct CorrelationModelParams {
  /// Algorithm 3 of Mahmood and Ridao 2017, by which cells are occupied or free.
  models::OccupiedSectorParams sector{};
  /// Of the local map; it need not be that of the room's.
  double cell_m = 0.05;
  models::CorrelationParams correlation{};
};

/// The correlation of a local map, made of the readings around the robot, with the map of the room
/// (Mahmood and Ridao 2017, section 3.3): a robot beside a wall that sees none agrees badly, and so
/// does one that sees a wall where there is none. A map's unknown cells are half occupied.
class CorrelationModel : public ObservationModel {
 public:
  /// Throws std::invalid_argument for invalid settings.
  CorrelationModel(mapping::RasterMap map, const CorrelationModelParams& params);

  const mapping::RasterMap& map() const override { return map_; }
  void observe(std::span<const RangeReading> readings) override;
  /// Readings share one local map: 1, or 0 where none says anything.
  std::size_t count() const override { return local_.empty() ? 0 : 1; }
  void make_ready(const Particles& /*particles*/, const Workers& /*workers*/) override {}
  void update_weights(float likelihood_exponent,
                      ParticleRange range,
                      Particles& particles) const override;

 private:
  struct LocalCell {
    double x_m = 0.0;  ///< Its middle, from the robot.
    double y_m = 0.0;
    double occupancy = 0.0;
  };

  double occupancy_at(double x_cells, double y_cells) const;

  mapping::RasterMap map_;
  std::vector<float> occupancy_;  ///< Of the map's cells, row by row.
  CorrelationModelParams params_;
  models::OccupiedSector sector_;
  models::CorrelationLikelihood likelihood_;
  std::vector<LocalCell> local_;
};

}  // namespace echomap::localization
