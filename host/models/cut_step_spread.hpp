// SPDX-License-Identifier: MIT
#pragma once

#include "host/models/odometry_motion.hpp"

namespace echomap::models {

/// The motion over which odometry errs in one way: a patch of floor, a speed of the wheels. Errors
/// of one such motion do not depend on those of the next. Ours.
struct WholeStep {
  double drive_m = 0.2;
  double turn_rad = 0.5;
};

/// What the n-th part of a whole step adds to the uncertainty: an n-th of its variances. However
/// finely a motion is cut, its parts come to the same sum; `OdometryMotion::spread` alone makes a
/// robot the surer the more often it reports.
MotionSpread cut_step_spread(const OdometryMotion& motion,
                             const OdometryStep& step,
                             const WholeStep& whole);

}  // namespace echomap::models
