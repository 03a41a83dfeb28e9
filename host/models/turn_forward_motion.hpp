// SPDX-License-Identifier: MIT
#pragma once

#include "host/models/odometry_motion.hpp"

namespace echomap::models {

/// How far a turn and a drive are off, however long they are: turn and forward noise of Singh and
/// Bedi 2013, section 4.3, with the numbers of their TriBot.
struct TurnForwardMotionParams {
  double turn_stddev_rad = 0.0043633;  ///< 0.25 degrees.
  double forward_stddev_m = 0.0005;
};

/// The motion model of Singh and Bedi 2013, Algorithm 1, line 37: a robot that turns on the spot
/// and then drives straight on, with normal noise of one size in each. What does not turn or drive
/// has no noise.
class TurnForwardMotion {
 public:
  /// Throws std::invalid_argument for a deviation that is negative or not finite.
  explicit TurnForwardMotion(const TurnForwardMotionParams& params = {});

  MotionSpread spread(const OdometryStep& step) const;

 private:
  TurnForwardMotionParams params_;
};

}  // namespace echomap::models
