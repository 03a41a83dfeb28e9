// SPDX-License-Identifier: MIT
#include "hil_mock/world/scalar_sensor.hpp"

#include <algorithm>
#include <cmath>

namespace echomap::world {
namespace {

constexpr double kSupplyMillivolts = 5000.0;

/// Time to the next event of a Poisson process of rate 1.
double draw_exponential(NoiseStream& noise) { return -std::log(1.0 - noise.uniform()); }

bool is_same(const geometry::Pose2& one, const geometry::Pose2& other) {
  return one.position_m() == other.position_m() && one.heading_rad() == other.heading_rad();
}

}  // namespace

ScalarSensor::ScalarSensor(const FloorPlan& plan,
                           const ScalarSensorParams& params,
                           const NoiseStream& noise)
    : plan_(plan), params_(params), noise_(noise), until_event_(draw_exponential(noise_)) {}

void ScalarSensor::step(double dt_s, const geometry::Pose2& T_world_robot) {
  const bool is_light = params_.kind == ScalarSensorKind::kLight;
  if (!is_known_ || !is_same(T_world_robot, T_world_robot_)) {
    const SourceKind kind = is_light ? SourceKind::kLight : SourceKind::kRadiation;
    rate_or_lux_ = params_.sensitivity * field_at(plan_, kind, T_world_robot * params_.mount_m);
    T_world_robot_ = T_world_robot;
    is_known_ = true;
  }
  pulses_.clear();
  if (is_light) {
    const double mean = params_.dark_millivolts + rate_or_lux_;
    const double noisy = mean + params_.noise_millivolts * noise_.normal();
    millivolts_ = std::clamp(noisy, 0.0, kSupplyMillivolts);
  } else {
    count(dt_s);
  }
}

void ScalarSensor::count(double dt_s) {
  double at_s = 0.0;
  while (rate_or_lux_ > 0.0 && until_event_ < rate_or_lux_ * (dt_s - at_s)) {
    at_s += until_event_ / rate_or_lux_;
    until_event_ = draw_exponential(noise_);
    if (at_s >= dead_s_) {
      pulses_.push_back({at_s, at_s + params_.pulse_s});
      dead_s_ = at_s + params_.dead_time_s;
    }
  }
  until_event_ -= rate_or_lux_ * (dt_s - at_s);
  dead_s_ -= dt_s;
}

}  // namespace echomap::world
