// SPDX-License-Identifier: MIT
#include "host/exploration/random_bounce.hpp"

#include <chrono>

#include "host/geometry/parameter_validator.hpp"
#include "host/models/uniform_sample.hpp"

namespace echomap::exploration {

namespace {

void validate(const RandomBounceParams& params) {
  geometry::ParameterValidator("random-bounce")
      .positive("tick_s", params.tick_s)
      .positive("speed_m_per_s", params.speed_m_per_s)
      .positive("spin_rad_per_s", params.spin_rad_per_s)
      .positive("min_turn_rad", params.min_turn_rad)
      .at_least("max_turn_rad", params.max_turn_rad, params.min_turn_rad)
      .positive("max_s", params.max_s)
      .positive("max_distance_m", params.max_distance_m);
}

}  // namespace

RandomBounce::RandomBounce(const RandomBounceParams& params, std::mt19937& random)
    : params_(params), random_(random) {
  validate(params);
}

Motion RandomBounce::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  if (is_over(snapshot.latest)) {
    return Finished{FinishReason::kComplete};
  }
  const auto& hazards = snapshot.hazards;
  const bool is_stopped = last == MotionResult::kHazard || last == MotionResult::kStalled;
  if (!hazards.is_touching() && !hazards.virtual_wall && !is_stopped) {
    return Roll{params_.speed_m_per_s, 0.0, params_.tick_s};
  }
  // Not a standard distribution: the choice has to repeat with any standard library.
  const double share = models::uniform_sample(random_);
  const double turn_rad =
      params_.min_turn_rad + share * (params_.max_turn_rad - params_.min_turn_rad);
  return Roll{0.0, params_.spin_rad_per_s, turn_rad / params_.spin_rad_per_s};
}

bool RandomBounce::is_over(const pipeline::StampedPose& now) {
  if (!first_) {
    first_ = now;
    last_ = now;
  }
  travelled_m_ += (now.T_map_robot.position_m() - last_.T_map_robot.position_m()).norm();
  last_ = now;
  const std::chrono::duration<double> driven = now.stamp - first_->stamp;
  return driven.count() >= params_.max_s || travelled_m_ >= params_.max_distance_m;
}

}  // namespace echomap::exploration
