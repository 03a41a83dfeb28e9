// SPDX-License-Identifier: MIT
#include "host/localization/motion_update.hpp"

#include "host/mapping/vector_clones.hpp"

namespace echomap::localization {

namespace {

struct Motion {
  float before_rad, drive_m, after_rad;
  float before_std_rad, drive_std_m, after_std_rad, side_std_m;
};

/// Two random words a particle, by their numbers.
ECHOMAP_VECTOR_CLONES
void move_all(float* __restrict x_m,
              float* __restrict y_m,
              float* __restrict heading_rad,
              ParticleRange range,
              const Motion motion,
              const RandomKey key) {
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const auto number = static_cast<std::uint32_t>(2 * i);
    const NormalPair turns = normal_pair(random_bits(key, number));
    const NormalPair ways = normal_pair(random_bits(key, number + 1));
    const float towards_rad =
        heading_rad[i] + motion.before_rad + motion.before_std_rad * turns.first;
    const SinCos ahead = sin_cos(towards_rad);
    const float drive_m = motion.drive_m + motion.drive_std_m * ways.first;
    const float side_m = motion.side_std_m * ways.second;
    x_m[i] += drive_m * ahead.cos - side_m * ahead.sin;
    y_m[i] += drive_m * ahead.sin + side_m * ahead.cos;
    heading_rad[i] = wrapped(towards_rad + motion.after_rad + motion.after_std_rad * turns.second);
  }
}

}  // namespace

void move(Particles& particles,
          ParticleRange range,
          const models::OdometryStep& step,
          const models::MotionSpread& spread,
          RandomKey key) {
  const Motion motion{static_cast<float>(step.turn_before_rad),
                      static_cast<float>(step.drive_m),
                      static_cast<float>(step.turn_after_rad),
                      static_cast<float>(spread.turn_before_rad),
                      static_cast<float>(spread.drive_m),
                      static_cast<float>(spread.turn_after_rad),
                      static_cast<float>(spread.side_m)};
  move_all(
      particles.x_m.data(), particles.y_m.data(), particles.heading_rad.data(), range, motion, key);
}

}  // namespace echomap::localization
