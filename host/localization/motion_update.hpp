// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "host/localization/lane_math.hpp"
#include "host/localization/particles.hpp"
#include "host/models/odometry_motion.hpp"

namespace echomap::localization {

/// How the errors of a motion are drawn.
enum class NoiseShape : std::uint8_t {
  kNormal,
  kUniformSum,  ///< Sums of twelve even draws (Mukherjee et al., section V-A): nearly normal, and
                ///< never beyond six deviations.
};

/// Moves particles by an odometry step with noise of their own (Thrun, Burgard and Fox 2005,
/// table 5.6; the spread may come from any model). A particle's noise depends on its number and on
/// `key` alone.
void move(Particles& particles,
          ParticleRange range,
          const models::OdometryStep& step,
          const models::MotionSpread& spread,
          RandomKey key,
          NoiseShape shape = NoiseShape::kNormal);

}  // namespace echomap::localization
