// SPDX-License-Identifier: MIT
#pragma once

#include "host/models/odometry_motion.hpp"

namespace echomap::models {

/// alpha1 to alpha4 of Mukherjee et al., section VI, which they took from 70 drives of an iRobot
/// Create. The numbers are in their order: alpha1 is the turn's error from driving and alpha2 that
/// from turning, which Thrun et al. (2005, table 5.6) number the other way round.
struct LinearOdometryMotionParams {
  double alpha1_rad_per_m = 0.0145444;   ///< alpha1: 0.3 degrees in 360 mm.
  double alpha2 = 0.0027778;             ///< alpha2: 1 degree in 360.
  double alpha3 = 0.026;                 ///< alpha3: mm a mm.
  double alpha4_m_per_rad = 1.14592e-5;  ///< alpha4: 0.0002 mm a degree.
};

/// The odometry model of Mukherjee et al., equations 9 to 13: a turn by phi, then a drive of d,
///
///     Phi = phi - sample(alpha1 d + alpha2 phi)   (9)
///     D   = d - sample(alpha3 d + alpha4 phi)     (10)
///
/// with errors that grow with the motion itself, not with its square. `sample(b)` is their
/// sample_normal_distribution, whose deviation is b / 3 (uniform_sum.hpp); b is taken without sign.
/// A second turn, as a drive along an arc ends with, errs by alpha2 too.
class LinearOdometryMotion {
 public:
  /// Throws std::invalid_argument for a parameter that is negative or not finite.
  explicit LinearOdometryMotion(const LinearOdometryMotionParams& params = {});

  MotionSpread spread(const OdometryStep& step) const;

 private:
  LinearOdometryMotionParams params_;
};

}  // namespace echomap::models
