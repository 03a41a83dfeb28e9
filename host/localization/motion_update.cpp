// SPDX-License-Identifier: MIT
#include "host/localization/motion_update.hpp"

#include "host/mapping/vector_clones.hpp"
#include "host/models/uniform_sum.hpp"

namespace echomap::localization {

namespace {

struct Motion {
  float before_rad, drive_m, after_rad;
  float before_stddev_rad, drive_stddev_m, after_stddev_rad, side_stddev_m;
};

/// Standard numbers, one for each error of a motion.
struct MotionNoise {
  float before, drive, after, side;
};

[[gnu::always_inline]] inline void move_one(
    const Motion& motion, const MotionNoise& noise, float& x_m, float& y_m, float& heading_rad) {
  const float towards_rad =
      heading_rad + motion.before_rad + motion.before_stddev_rad * noise.before;
  const SinCos ahead = sin_cos(towards_rad);
  const float drive_m = motion.drive_m + motion.drive_stddev_m * noise.drive;
  const float side_m = motion.side_stddev_m * noise.side;
  x_m += drive_m * ahead.cos - side_m * ahead.sin;
  y_m += drive_m * ahead.sin + side_m * ahead.cos;
  heading_rad = wrapped(towards_rad + motion.after_rad + motion.after_stddev_rad * noise.after);
}

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
    move_one(motion,
             {turns.first, ways.first, turns.second, ways.second},
             x_m[i],
             y_m[i],
             heading_rad[i]);
  }
}

/// Twelve random words for each of four errors.
void move_by_uniform_sums(Particles& particles,
                          ParticleRange range,
                          const Motion& motion,
                          RandomKey key) {
  for (std::size_t i = range.begin; i < range.end; ++i) {
    auto number = static_cast<std::uint32_t>(48 * i);
    const auto sum = [&] {
      return static_cast<float>(models::uniform_sum_sample(models::uniform_sum_b(1.0), [&] {
        return static_cast<double>(uniform(random_bits(key, number++)));
      }));
    };
    const float before = sum();
    const float drive = sum();
    const float after = sum();
    move_one(motion,
             {before, drive, after, sum()},
             particles.x_m[i],
             particles.y_m[i],
             particles.heading_rad[i]);
  }
}

}  // namespace

void move(Particles& particles,
          ParticleRange range,
          const models::OdometryStep& step,
          const models::MotionSpread& spread,
          RandomKey key,
          NoiseShape shape) {
  const Motion motion{static_cast<float>(step.turn_before_rad),
                      static_cast<float>(step.drive_m),
                      static_cast<float>(step.turn_after_rad),
                      static_cast<float>(spread.turn_before_rad),
                      static_cast<float>(spread.drive_m),
                      static_cast<float>(spread.turn_after_rad),
                      static_cast<float>(spread.side_m)};
  if (shape == NoiseShape::kUniformSum) {
    move_by_uniform_sums(particles, range, motion, key);
    return;
  }
  move_all(
      particles.x_m.data(), particles.y_m.data(), particles.heading_rad.data(), range, motion, key);
}

}  // namespace echomap::localization
