// SPDX-License-Identifier: MIT
#include "host/models/linear_odometry_motion.hpp"

#include <cmath>
#include <stdexcept>

#include "host/models/uniform_sum.hpp"

namespace echomap::models {

LinearOdometryMotion::LinearOdometryMotion(const LinearOdometryMotionParams& params)
    : params_(params) {
  for (const double share : {params.turn_by_drive_rad_per_m,
                             params.turn_by_turn,
                             params.drive_by_drive,
                             params.drive_by_turn_m_per_rad}) {
    if (!(share >= 0.0) || !std::isfinite(share)) {
      throw std::invalid_argument("linear odometry motion: an alpha is not negative, and finite");
    }
  }
}

MotionSpread LinearOdometryMotion::spread(const OdometryStep& step) const {
  const double turn_rad = std::abs(step.turn_before_rad);
  const double after_rad = std::abs(step.turn_after_rad);
  const double drive_m = std::abs(step.drive_m);
  const double turn_b =  // Equation (9).
      params_.turn_by_drive_rad_per_m * drive_m + params_.turn_by_turn * turn_rad;
  const double drive_b =  // Equation (10).
      params_.drive_by_drive * drive_m + params_.drive_by_turn_m_per_rad * (turn_rad + after_rad);
  return {uniform_sum_std(turn_b),
          uniform_sum_std(drive_b),
          uniform_sum_std(params_.turn_by_turn * after_rad),
          0.0};
}

}  // namespace echomap::models
