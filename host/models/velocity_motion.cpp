// SPDX-License-Identifier: MIT
#include "host/models/velocity_motion.hpp"

#include <cmath>
#include <stdexcept>

namespace echomap::models {

namespace {

/// Below this turn an arc and its chord differ by less than rounding.
constexpr double kStraightRad = 1e-9;

}  // namespace

VelocityMotion::VelocityMotion(const VelocityMotionParams& params) : params_(params) {
  for (const double share : {params.speed_by_speed,
                             params.speed_by_turn_m2_per_rad2,
                             params.turn_by_speed_rad2_per_m2,
                             params.turn_by_turn,
                             params.final_by_speed_rad2_per_m2,
                             params.final_by_turn}) {
    if (!(share >= 0.0) || !std::isfinite(share)) {
      throw std::invalid_argument("velocity motion: a variance is not negative, and finite");
    }
  }
}

geometry::Pose2 VelocityMotion::sample(const VelocityCommand& command,
                                       const VelocityNoise& noise) const {
  const double speed2 = command.speed_m_per_s * command.speed_m_per_s;
  const double turn2 = command.turn_rad_per_s * command.turn_rad_per_s;
  const auto deviation = [&](double by_speed, double by_turn) {
    return std::sqrt(by_speed * speed2 + by_turn * turn2);
  };
  const double speed_m_per_s =  // Line 2.
      command.speed_m_per_s +
      deviation(params_.speed_by_speed, params_.speed_by_turn_m2_per_rad2) * noise.speed;
  const double turn_rad_per_s =  // Line 3.
      command.turn_rad_per_s +
      deviation(params_.turn_by_speed_rad2_per_m2, params_.turn_by_turn) * noise.turn;
  const double final_rad_per_s =  // Line 4.
      deviation(params_.final_by_speed_rad2_per_m2, params_.final_by_turn) * noise.final_turn;
  const double turn_rad = turn_rad_per_s * command.duration_s;
  const double drive_m = speed_m_per_s * command.duration_s;
  const double end_rad = turn_rad + final_rad_per_s * command.duration_s;  // Line 7.
  if (std::abs(turn_rad) < kStraightRad) {
    return {drive_m, 0.0, end_rad};
  }
  const double radius_m = drive_m / turn_rad;
  return {radius_m * std::sin(turn_rad),  // Lines 5 and 6, from a heading of 0.
          radius_m * (1.0 - std::cos(turn_rad)),
          end_rad};
}

MotionSpread VelocityMotion::spread(const OdometryStep& arc) const {
  const double drive2 = arc.drive_m * arc.drive_m;
  const double turn_rad = arc.turn_before_rad + arc.turn_after_rad;
  const double turn2 = turn_rad * turn_rad;
  const double turn_variance = params_.turn_by_speed_rad2_per_m2 * drive2 +  //
                               params_.turn_by_turn * turn2;
  const double final_variance = params_.final_by_speed_rad2_per_m2 * drive2 +  //
                                params_.final_by_turn * turn2;
  return {std::sqrt(0.25 * turn_variance),
          std::sqrt(params_.speed_by_speed * drive2 + params_.speed_by_turn_m2_per_rad2 * turn2),
          std::sqrt(0.75 * turn_variance + final_variance),
          0.0};
}

}  // namespace echomap::models
