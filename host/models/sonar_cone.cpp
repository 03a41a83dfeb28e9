// SPDX-License-Identifier: MIT
#include "host/models/sonar_cone.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/geometry/parameter_validator.hpp"
#include "host/models/concepts.hpp"

namespace echomap::models {

static_assert(InverseModel<SonarCone>);

namespace {

/// Cells of 5 cm, the maps' habit, share an arc's evidence.
constexpr double kCellM = 0.05;

}  // namespace

SonarCone::SonarCone(const SonarConeParams& params) : params_(params) {
  geometry::ParameterValidator("sonar cone")
      .positive("beam_half_angle_rad", params.beam_half_angle_rad)
      .at_most("beam_half_angle_rad", params.beam_half_angle_rad, std::numbers::pi / 4.0)
      .within("edge_weight", params.edge_weight, 0.0, 1.0)
      .positive("max_range_m", params.max_range_m)
      .at_most("max_range_m", params.max_range_m, 20.0)
      .positive("silent_to_m", params.silent_to_m)
      .positive("arc_half_thickness_m", params.arc_half_thickness_m)
      .at_least("free_margin_m", params.free_margin_m, 0.0)
      .positive("overheard_chance", params.overheard_chance)
      .below("overheard_chance", params.overheard_chance, 1.0)
      .positive("silent_chance", params.silent_chance)
      .below("silent_chance", params.silent_chance, 1.0)
      .positive("arc_evidence", params.arc_evidence)
      .positive("cell_evidence", params.cell_evidence);
}

double SonarCone::weight(double off_axis_rad) const {
  const double share = off_axis_rad / params_.beam_half_angle_rad;
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
         std::abs(point.off_axis_rad) <= params_.beam_half_angle_rad;
}

double SonarCone::evidence(const SensorReading& reading, const PolarPoint& point) const {
  if (!reading.range_m || !on_arc(reading, point)) {
    return std::log(miss_chance(reading, point));
  }
  const double area_m2 =
      4.0 * params_.beam_half_angle_rad * params_.arc_half_thickness_m * *reading.range_m;
  const double cells = std::max(1.0, area_m2 / (kCellM * kCellM));
  return std::min(params_.cell_evidence, params_.arc_evidence * weight(point.off_axis_rad) / cells);
}

double SonarCone::reach_m(const SensorReading& reading) const {
  return reading.range_m ? *reading.range_m + params_.arc_half_thickness_m : free_to_m(reading);
}

}  // namespace echomap::models
