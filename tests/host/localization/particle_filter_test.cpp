// SPDX-License-Identifier: MIT
#include "host/localization/particle_filter.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/localization/pose_hypotheses.hpp"
#include "host/localization/range_table_model.hpp"
#include "tests/host/localization/corridor.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/resident_memory.hpp"

namespace echomap::localization {
namespace {

double mean_x_m(const Particles& particles) {
  double sum = 0.0;
  for (const float x_m : particles.x_m) {
    sum += static_cast<double>(x_m);
  }
  return sum / static_cast<double>(particles.size());
}

struct CorridorScene {
  RangeTableModel model{RangeTable(kCorridor, {0.0, 4.0}),
                        models::BeamModel(models::laser_returns())};

  ObservationModel& ahead(double range_m) {
    const RangeReading reading{{}, range_m};
    model.observe(std::span(&reading, 1));
    return model;
  }
};

TEST(ParticleFilter, GoesWhereTheReadingsSay) {
  CorridorScene scene;
  ParticleFilter filter({}, std::mt19937(1));
  filter.start_at({1.0, 0.2, 0.0}, 0.3, 0.01);
  for (int i = 0; i < 10; ++i) {
    filter.update_weights(scene.ahead(1.7));
    filter.resample_if_needed();
  }
  EXPECT_NEAR(mean_x_m(filter.particles()), 1.2, 0.06);
}

TEST(ParticleFilter, SaysHowLikelyTheReadingsWere) {
  CorridorScene scene;
  ParticleFilter near({}, std::mt19937(1));
  ParticleFilter far({}, std::mt19937(1));
  near.start_at({1.2, 0.2, 0.0}, 0.01, 0.01);
  far.start_at({2.4, 0.2, 0.0}, 0.01, 0.01);
  EXPECT_GT(near.update_weights(scene.ahead(1.7)), far.update_weights(scene.ahead(1.7)));
}

std::size_t size_after_a_sweep(double start_stddev) {
  CorridorScene scene;
  ParticleFilter filter({.min_particles = 10, .max_particles = 20'000, .resampling_share = 1.0},
                        std::mt19937(1));
  filter.start_at({1.2, 0.2, 0.0}, start_stddev, start_stddev);
  filter.update_weights(scene.ahead(1.7));
  filter.resample_if_needed();
  return filter.particles().size();
}

TEST(ParticleFilter, NeedsFewerParticlesTheSurerItIs) {
  EXPECT_LT(size_after_a_sweep(0.03), size_after_a_sweep(0.3) / 2);
  EXPECT_GE(size_after_a_sweep(0.03), 10U);
}

TEST(ParticleFilter, HoldsAMillionParticles) {
  constexpr std::size_t kMany = 1'000'000;
  CorridorScene scene;
  const double before_mb = tests::resident_mb();
  ParticleFilter filter({.min_particles = kMany, .max_particles = kMany, .resampling_share = 1.0},
                        std::mt19937(1),
                        Workers(2));
  filter.start_at({1.0, 0.2, 0.0}, 0.3, 0.01);
  for (int i = 0; i < 3; ++i) {
    filter.move({0.0, 0.01, 0.0}, {0.01, 0.01, 0.01, 0.01});
    filter.update_weights(scene.ahead(1.7));
    filter.resample_if_needed();
  }
  EXPECT_EQ(filter.particles().size(), kMany);
  EXPECT_NEAR(mean_x_m(filter.particles()), 1.2, 0.1);
  EXPECT_LT(tests::resident_mb() - before_mb, 64.0);  // 64 bytes a particle.
  double probability = 0.0;
  for (const PoseHypothesis& hypothesis : find_hypotheses(filter.particles(), filter.weights())) {
    probability += hypothesis.probability;
  }
  EXPECT_NEAR(probability, 1.0, 1e-9);
}

TEST(ParticleFilter, TakesInAnotherByItsShare) {
  ParticleFilter here({}, std::mt19937(1));
  ParticleFilter elsewhere({}, std::mt19937(2));
  here.start_at({0.5, 0.2, 0.0}, 0.01, 0.01);
  elsewhere.start_at({2.5, 0.2, 0.0}, 0.01, 0.01);
  here.join(elsewhere, 0.75);
  const auto& x_m = here.particles().x_m;
  const auto there = std::count_if(x_m.begin(), x_m.end(), [](float x) { return x > 1.5F; });
  EXPECT_NEAR(static_cast<double>(there) / static_cast<double>(x_m.size()), 0.75, 0.001);
}

TEST(ParticleFilter, IsAnywhereWithoutParticles) {
  CorridorScene scene;
  ParticleFilter filter({}, std::mt19937(1));
  filter.start_from({}, 0.1, 0.1);
  EXPECT_TRUE(filter.empty());
  EXPECT_EQ(filter.update_weights(scene.ahead(1.0)), 0.0);
  filter.resample_if_needed();
  filter.move({0.1, 0.1, 0.1}, {});
  EXPECT_TRUE(filter.empty());
}

TEST(ParticleFilter, RefusesSettingsWithoutSense) {
  EXPECT_THROW(ParticleFilter({.min_particles = 0}, {}), std::invalid_argument);
  EXPECT_THROW(ParticleFilter({.likelihood_exponent = 1.1}, {}), std::invalid_argument);
  EXPECT_THROW(ParticleFilter({.sample_error = 0.0}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
