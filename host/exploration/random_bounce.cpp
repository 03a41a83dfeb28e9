// SPDX-License-Identifier: MIT
#include "host/exploration/random_bounce.hpp"

#include <chrono>
#include <stdexcept>

#include "host/models/uniform_sample.hpp"

namespace echomap::exploration {

namespace {

void check(const RandomBounceParams& params) {
  const bool moves = params.tick_s > 0.0 && params.speed_m_per_s > 0.0 &&
                     params.spin_rad_per_s > 0.0 && params.least_turn_rad > 0.0 &&
                     params.most_turn_rad >= params.least_turn_rad;
  if (!moves || !(params.most_s > 0.0) || !(params.most_way_m > 0.0)) {
    throw std::invalid_argument("random-bounce: a parameter is outside of its range");
  }
}

}  // namespace

RandomBounce::RandomBounce(const RandomBounceParams& params, std::mt19937& random)
    : params_(params), random_(random) {
  check(params);
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
      params_.least_turn_rad + share * (params_.most_turn_rad - params_.least_turn_rad);
  return Roll{0.0, params_.spin_rad_per_s, turn_rad / params_.spin_rad_per_s};
}

bool RandomBounce::is_over(const pipeline::StampedPose& now) {
  if (!first_) {
    first_ = now;
    last_ = now;
  }
  way_m_ += (now.T_map_robot.position_m() - last_.T_map_robot.position_m()).norm();
  last_ = now;
  const std::chrono::duration<double> driven = now.stamp - first_->stamp;
  return driven.count() >= params_.most_s || way_m_ >= params_.most_way_m;
}

}  // namespace echomap::exploration
