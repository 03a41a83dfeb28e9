// SPDX-License-Identifier: MIT
#include "tests/benchmarks/localization_workloads.hpp"

#include <numbers>
#include <utility>

#include "host/localization/motion_update.hpp"
#include "host/localization/pose_hypotheses.hpp"
#include "host/localization/resampling.hpp"

namespace echomap::bench {

using namespace localization;

Particles tracking_cloud(std::size_t count) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Particles particles;
  particles.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x_m = 7.0 + 0.2 * normal(random);
    const double y_m = 4.0 + 0.2 * normal(random);
    particles.set_pose(i, {x_m, y_m, 0.5 + 0.1 * normal(random)});
  }
  return particles;
}

std::vector<RangeReading> sweep(int beams) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> range_m(1.0, 3.5);
  std::vector<RangeReading> readings;
  for (int i = 0; i < beams; ++i) {
    const double bearing_rad = std::numbers::pi * (2.0 * i / beams - 1.0);
    readings.push_back({{0.0, 0.0, bearing_rad}, range_m(random)});
  }
  return readings;
}

FilterStep::FilterStep(const LikelihoodField& field, std::size_t particles, int threads)
    : field_(field), workers_(threads), particles_(tracking_cloud(particles)) {}

void FilterStep::operator()() {
  const RandomKey key{static_cast<std::uint32_t>(random_()), static_cast<std::uint32_t>(random_())};
  const std::size_t count = particles_.size();
  share_blocks(workers_, count, [&](ParticleRange range, std::size_t) {
    move(particles_, range, {0.0, 0.0, 0.0}, {0.01, 0.02, 0.01, 0.01}, key);
    field_.update_weights(readings_, 0.05F, range, particles_);
  });
  relative_weights(particles_, weights_, workers_);
  find_hypotheses(particles_, weights_, {}, workers_);
  draw_ancestors(weights_, count, ResamplingScheme::kSystematic, random_, ancestors_, workers_);
  take_ancestors(particles_, ancestors_, drawn_, workers_);
  std::swap(particles_, drawn_);
}

}  // namespace echomap::bench
