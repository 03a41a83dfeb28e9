// SPDX-License-Identifier: MIT
#include "host/models/sonar_cone.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "host/models/concepts.hpp"

namespace echomap::models {

static_assert(InverseModel<SonarCone>);

namespace {

/// Cells of 5 cm, the maps' habit, share an arc's evidence.
constexpr double kCellM = 0.05;

bool is_chance(double value) { return value > 0.0 && value < 1.0; }

}  // namespace

SonarCone::SonarCone(const SonarConeParams& params) : params_(params) {
  const bool cone_ok = params.half_angle_rad > 0.0 &&
                       params.half_angle_rad <= std::numbers::pi / 4.0 &&
                       params.edge_weight >= 0.0 && params.edge_weight <= 1.0;
  const bool lengths_ok = params.max_range_m > 0.0 && params.max_range_m <= 20.0 &&
                          params.silent_to_m > 0.0 && params.arc_half_thickness_m > 0.0 &&
                          params.free_margin_m >= 0.0;
  const bool evidence_ok = is_chance(params.overheard_chance) && is_chance(params.silent_chance) &&
                           params.arc_evidence > 0.0 && params.cell_evidence > 0.0;
  if (!cone_ok || !lengths_ok || !evidence_ok) {
    throw std::invalid_argument("sonar cone: a parameter is outside of its range");
  }
}

double SonarCone::weight(double off_axis_rad) const {
  const double share = off_axis_rad / params_.half_angle_rad;
  return std::abs(share) > 1.0 ? 0.0 : 1.0 - (1.0 - params_.edge_weight) * share * share;
}

double SonarCone::miss_chance(const SensorReading& reading, const PolarPoint& point) const {
  if (point.range_m >= free_to_m(reading)) {
    return 1.0;
  }
  const double miss = reading.range_m ? params_.overheard_chance : params_.silent_chance;
  return 1.0 - weight(point.off_axis_rad) * (1.0 - miss);
}

double SonarCone::free_to_m(const SensorReading& reading) const {
  return reading.range_m ? *reading.range_m - params_.free_margin_m
                         : std::min(params_.silent_to_m, params_.max_range_m);
}

bool SonarCone::on_arc(const SensorReading& reading, const PolarPoint& point) const {
  return reading.range_m &&
         std::abs(point.range_m - *reading.range_m) <= params_.arc_half_thickness_m &&
         std::abs(point.off_axis_rad) <= params_.half_angle_rad;
}

double SonarCone::evidence(const SensorReading& reading, const PolarPoint& point) const {
  if (!reading.range_m || !on_arc(reading, point)) {
    return std::log(miss_chance(reading, point));
  }
  const double area_m2 =
      4.0 * params_.half_angle_rad * params_.arc_half_thickness_m * *reading.range_m;
  const double cells = std::max(1.0, area_m2 / (kCellM * kCellM));
  return std::min(params_.cell_evidence, params_.arc_evidence * weight(point.off_axis_rad) / cells);
}

double SonarCone::reach_m(const SensorReading& reading) const {
  return reading.range_m ? *reading.range_m + params_.arc_half_thickness_m : free_to_m(reading);
}

}  // namespace echomap::models
