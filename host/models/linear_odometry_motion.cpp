// SPDX-License-Identifier: MIT
#include "host/models/linear_odometry_motion.hpp"

#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/models/uniform_sum.hpp"

namespace echomap::models {

LinearOdometryMotion::LinearOdometryMotion(const LinearOdometryMotionParams& params)
    : params_(params) {
  geometry::ParameterValidator("linear odometry motion")
      .nonnegative_finite("alpha1_rad_per_m", params.alpha1_rad_per_m)
      .nonnegative_finite("alpha2", params.alpha2)
      .nonnegative_finite("alpha3", params.alpha3)
      .nonnegative_finite("alpha4_m_per_rad", params.alpha4_m_per_rad);
}

MotionSpread LinearOdometryMotion::spread(const OdometryStep& step) const {
  const double turn_rad = std::abs(step.turn_before_rad);
  const double after_rad = std::abs(step.turn_after_rad);
  const double drive_m = std::abs(step.drive_m);
  const double turn_b =  // Equation (9).
      params_.alpha1_rad_per_m * drive_m + params_.alpha2 * turn_rad;
  const double drive_b =  // Equation (10).
      params_.alpha3 * drive_m + params_.alpha4_m_per_rad * (turn_rad + after_rad);
  return {uniform_sum_stddev(turn_b),
          uniform_sum_stddev(drive_b),
          uniform_sum_stddev(params_.alpha2 * after_rad),
          0.0};
}

}  // namespace echomap::models
