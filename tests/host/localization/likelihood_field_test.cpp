// SPDX-License-Identifier: MIT
#include "host/localization/likelihood_field.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::localization {
namespace {

const mapping::RasterMap kBlockRoom = tests::map_from({"##############",
                                                       "#............#",
                                                       "#....##......#",
                                                       "#....##......#",
                                                       "#............#",
                                                       "##############"},
                                                      0.1,
                                                      {-0.3, 0.2});

TEST(LikelihoodField, FallsWithTheDistanceToTheNearestWall) {
  const LikelihoodField field(kBlockRoom, {.hit_stddev_m = 0.1, .random_share = 0.05});
  EXPECT_NEAR(field.log_likelihood({-0.25, 0.45}), 0.0, 1e-6);
  EXPECT_NEAR(field.log_likelihood({-0.15, 0.45}), std::log(0.95 * std::exp(-0.5) + 0.05), 1e-6);
  EXPECT_NEAR(field.log_likelihood({0.75, 0.55}), std::log(0.95 * std::exp(-2.0) + 0.05), 1e-6);
}

TEST(LikelihoodField, GoesOnBeyondTheMap) {
  const LikelihoodField field(kBlockRoom, {.hit_stddev_m = 0.1});
  const double beyond = field.log_likelihood({-50.0, 0.45});
  EXPECT_TRUE(std::isfinite(beyond));
  EXPECT_NEAR(beyond, field.log_likelihood({-0.35, 0.45}), 1e-9);
}

TEST(LikelihoodField, WeighsEachParticleByTheEndsOfItsBeams) {
  const LikelihoodField field(kBlockRoom);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  Particles particles;
  particles.resize(600);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.set_pose(i, {any(random), 0.3 + 0.3 * any(random), 6.0 * any(random) - 3.0});
  }
  const std::vector<RangeReading> readings{
      {{0.1, 0.05, 0.7}, 0.4}, {{}, std::nullopt}, {{}, 0.3}, {{0.0, 0.0, -2.0}, 0.8}};
  field.update_weights(readings, 0.5F, {0, particles.size()}, particles);
  std::size_t on_borders = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    double sum = 0.0;
    for (const RangeReading& reading : readings) {
      if (reading.range_m) {
        sum += field.log_likelihood(particles.pose(i) * reading.T_robot_sensor *
                                    Eigen::Vector2d(*reading.range_m, 0.0));
      }
    }
    on_borders += std::abs(static_cast<double>(particles.log_weight[i]) - 0.5 * sum) > 1e-5 ? 1 : 0;
  }
  EXPECT_LE(on_borders, 2U);  // Where single precision falls to the other cell.
}

TEST(LikelihoodField, PassesOverReadingsThatAreNoNumbers) {
  const LikelihoodField field(kBlockRoom);
  Particles particles;
  particles.resize(1);
  const std::vector<RangeReading> none{{{}, std::numeric_limits<double>::quiet_NaN()},
                                       {{}, std::numeric_limits<double>::infinity()}};
  field.update_weights(none, 1.0F, {0, 1}, particles);
  EXPECT_EQ(particles.log_weight[0], 0.0F);
}

TEST(LikelihoodField, RefusesSettingsWithoutSense) {
  EXPECT_THROW(LikelihoodField(kBlockRoom, {.hit_stddev_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(LikelihoodField(kBlockRoom, {.random_share = 0.0}), std::invalid_argument);
  EXPECT_THROW(LikelihoodField(kBlockRoom, {.max_distance_m = -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
