// SPDX-License-Identifier: MIT
#include "host/localization/correlation_model.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "host/geometry/parameter_validator.hpp"
#include "host/localization/usable_reading.hpp"

namespace echomap::localization {

namespace {

constexpr double kUnknown = 0.5;

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

double occupancy_of(mapping::CellState state) {
  switch (state) {
    case mapping::CellState::kFree:
      return 0.0;
    case mapping::CellState::kOccupied:
      return 1.0;
    case mapping::CellState::kUnknown:
      break;
  }
  return kUnknown;
}

}  // namespace

CorrelationModel::CorrelationModel(mapping::RasterMap map, const CorrelationModelParams& params)
    : map_(std::move(map)),
      params_(params),
      sector_(params.sector),
      likelihood_(params.correlation) {
  geometry::ParameterValidator("correlation model").positive("cell_m", params.cell_m);
  for (int y = 0; y < map_.rows(); ++y) {
    std::transform(
        map_.row(y),
        map_.row(y) + map_.columns(),
        std::back_inserter(occupancy_),
        [](mapping::CellState state) { return static_cast<float>(occupancy_of(state)); });
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
    local_.push_back({params_.cell_m * static_cast<double>(cell.first),
                      params_.cell_m * static_cast<double>(cell.second),
                      log_odds > 0.0 ? 1.0 : 0.0});
  }
}

void CorrelationModel::update_weights(float likelihood_exponent,
                                      ParticleRange range,
                                      Particles& particles) const {
  const double cells_per_m = 1.0 / map_.resolution_m();
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const geometry::Pose2 T_map_robot = particles.pose(i);
    const Eigen::Vector2d from_cells = cells_per_m * (T_map_robot.position_m() - map_.origin_m());
    const double cosine = cells_per_m * std::cos(T_map_robot.heading_rad());
    const double sine = cells_per_m * std::sin(T_map_robot.heading_rad());
    models::MapCorrelation correlation;
    for (const LocalCell& cell : local_) {
      const double x_cells = from_cells.x() + cosine * cell.x_m - sine * cell.y_m;
      const double y_cells = from_cells.y() + sine * cell.x_m + cosine * cell.y_m;
      correlation.add(occupancy_at(x_cells, y_cells), cell.occupancy);
    }
    particles.log_weight[i] +=
        likelihood_exponent * static_cast<float>(std::log(likelihood_.likelihood(correlation)));
  }
}

/// Beyond the map nothing is known.
double CorrelationModel::occupancy_at(double x_cells, double y_cells) const {
  const bool is_inside = x_cells >= 0.0 && y_cells >= 0.0 && x_cells < map_.columns() &&  //
                         y_cells < map_.rows();
  if (!is_inside) {
    return kUnknown;
  }
  const auto column = static_cast<std::size_t>(x_cells);
  const auto row = static_cast<std::size_t>(y_cells);
  return static_cast<double>(occupancy_[row * static_cast<std::size_t>(map_.columns()) + column]);
}

}  // namespace echomap::localization
