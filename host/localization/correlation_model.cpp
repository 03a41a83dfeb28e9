// SPDX-License-Identifier: MIT
#include "host/localization/correlation_model.hpp"

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "host/localization/usable_reading.hpp"

namespace echomap::localization {

namespace {

using Cell = std::pair<long, long>;
using Evidence = std::map<Cell, double>;

/// Adds a reading's evidence to the cells that it can reach.
void add_sector(const models::OccupiedSector& sector,
                const RangeReading& reading,
                double cell_m,
                Evidence& evidence) {
  const models::SensorReading heard{reading.range_m};
  const geometry::Pose2 T_sensor_robot = reading.T_robot_sensor.inverse();
  const Eigen::Vector2d from_m = reading.T_robot_sensor.position_m();
  const double reach_m = sector.reach_m(heard);
  const auto low = [&](double middle_m) { return std::lround((middle_m - reach_m) / cell_m); };
  const auto high = [&](double middle_m) { return std::lround((middle_m + reach_m) / cell_m); };
  for (long y = low(from_m.y()); y <= high(from_m.y()); ++y) {
    for (long x = low(from_m.x()); x <= high(from_m.x()); ++x) {
      const Eigen::Vector2d middle_m =
          cell_m * Eigen::Vector2d(static_cast<double>(x), static_cast<double>(y));
      const double log_odds =
          sector.evidence(heard, models::polar_point(T_sensor_robot * middle_m));
      if (log_odds != 0.0) {
        evidence[{x, y}] += log_odds;
      }
    }
  }
}

}  // namespace

CorrelationModel::CorrelationModel(mapping::RasterMap map, const CorrelationModelParams& params)
    : map_(std::move(map)),
      params_(params),
      sector_(params.sector),
      likelihood_(params.correlation) {
  if (!(params.cell_m > 0.0)) {
    throw std::invalid_argument("correlation model: a local cell is wider than 0");
  }
}

void CorrelationModel::observe(std::span<const RangeReading> readings) {
  Evidence evidence;
  for (const RangeReading& reading : readings) {
    if (is_usable(reading)) {
      add_sector(sector_, reading, params_.cell_m, evidence);
    }
  }
  local_.clear();
  for (const auto& [cell, log_odds] : evidence) {
    local_.push_back({params_.cell_m * Eigen::Vector2d(static_cast<double>(cell.first),
                                                       static_cast<double>(cell.second)),
                      log_odds > 0.0 ? 1.0 : 0.0});
  }
}

void CorrelationModel::weigh(float temper, ParticleRange range, Particles& particles) const {
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const geometry::Pose2 T_map_robot = particles.pose(i);
    const double cosine = std::cos(T_map_robot.heading_rad());
    const double sine = std::sin(T_map_robot.heading_rad());
    models::MapCorrelation correlation;
    for (const LocalCell& cell : local_) {
      const Eigen::Vector2d at_m(
          T_map_robot.x_m() + cosine * cell.middle_m.x() - sine * cell.middle_m.y(),
          T_map_robot.y_m() + sine * cell.middle_m.x() + cosine * cell.middle_m.y());
      correlation.add(occupancy_at(at_m), cell.occupancy);
    }
    particles.log_weight[i] +=
        temper * static_cast<float>(std::log(likelihood_.likelihood(correlation)));
  }
}

double CorrelationModel::occupancy_at(const Eigen::Vector2d& point_m) const {
  switch (map_.state(map_.cell_at(point_m))) {
    case mapping::CellState::kFree:
      return 0.0;
    case mapping::CellState::kOccupied:
      return 1.0;
    case mapping::CellState::kUnknown:
      break;
  }
  return 0.5;
}

}  // namespace echomap::localization
