// SPDX-License-Identifier: MIT
#include "host/models/cut_step_spread.hpp"

#include <algorithm>
#include <cmath>

namespace echomap::models {

MotionSpread cut_step_spread(const OdometryMotion& motion,
                             const OdometryStep& step,
                             const WholeStep& whole) {
  const double turn_rad = std::abs(step.turn_before_rad) + std::abs(step.turn_after_rad);
  const double wholes = std::max(std::abs(step.drive_m) / whole.drive_m, turn_rad / whole.turn_rad);
  if (wholes == 0.0) {
    return {};
  }
  MotionSpread spread = motion.spread(
      {step.turn_before_rad / wholes, step.drive_m / wholes, step.turn_after_rad / wholes});
  for (double* std_dev :
       {&spread.turn_before_rad, &spread.drive_m, &spread.turn_after_rad, &spread.side_m}) {
    *std_dev *= std::sqrt(wholes);
  }
  return spread;
}

}  // namespace echomap::models
