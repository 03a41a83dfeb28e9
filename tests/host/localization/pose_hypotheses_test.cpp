// SPDX-License-Identifier: MIT
#include "host/localization/pose_hypotheses.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::localization {
namespace {

struct Cloud {
  geometry::Pose2 middle;
  double stddev_m;
  double stddev_rad;
  std::size_t count;
};

Particles particles_of(const std::vector<Cloud>& clouds) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  Particles particles;
  std::size_t i = 0;
  for (const Cloud& cloud : clouds) {
    particles.resize(i + cloud.count);
    for (; i < particles.size(); ++i) {
      particles.set_pose(i,
                         {cloud.middle.x_m() + cloud.stddev_m * normal(random),
                          cloud.middle.y_m() + cloud.stddev_m * normal(random),
                          cloud.middle.heading_rad() + cloud.stddev_rad * normal(random)});
    }
  }
  return particles;
}

TEST(PoseHypotheses, TellCloudsApart) {
  const Particles particles = particles_of({{{1.0, 2.0, 0.5}, 0.1, 0.05, 3000},
                                            {{1.0, 2.0, -2.0}, 0.1, 0.05, 2000},
                                            {{4.0, 2.0, 0.5}, 0.1, 0.05, 1000}});
  const auto found = find_hypotheses(particles, std::vector<float>(6000, 1.0F));
  ASSERT_EQ(found.size(), 3U);
  EXPECT_NEAR(found[0].probability, 0.5, 1e-3);
  EXPECT_NEAR(found[1].probability, 1.0 / 3.0, 1e-3);
  EXPECT_NEAR(found[2].probability, 1.0 / 6.0, 1e-3);
  EXPECT_NEAR(found[1].T_map_robot.heading_rad(), -2.0, 0.01);
  EXPECT_NEAR(found[2].T_map_robot.x_m(), 4.0, 0.02);
}

TEST(PoseHypotheses, KnowMeanAndCovarianceAcrossTheBordersOfBins) {
  const Particles particles = particles_of({{{0.0, 0.0, 3.14}, 0.2, 0.1, 20'000}});
  const auto found = find_hypotheses(particles, std::vector<float>(20'000, 0.5F));
  ASSERT_FALSE(found.empty());
  EXPECT_GT(found[0].probability, 0.9);
  EXPECT_NEAR(found[0].T_map_robot.x_m(), 0.0, 0.02);
  EXPECT_NEAR(geometry::angle_between(found[0].T_map_robot.heading_rad(), 3.14), 0.0, 0.01);
  EXPECT_NEAR(std::sqrt(found[0].covariance(0, 0)), 0.2, 0.03);
  EXPECT_NEAR(std::sqrt(found[0].covariance(2, 2)), 0.1, 0.015);
}

TEST(PoseHypotheses, CountWeightsNotParticles) {
  const Particles particles =
      particles_of({{{0.0, 0.0, 0.0}, 0.05, 0.05, 1000}, {{3.0, 0.0, 0.0}, 0.05, 0.05, 10}});
  std::vector<float> weights(1010, 1e-3F);
  std::fill(weights.begin() + 1000, weights.end(), 1.0F);
  const auto found = find_hypotheses(particles, weights);
  EXPECT_NEAR(found.front().T_map_robot.x_m(), 3.0, 0.1);
  EXPECT_NEAR(found.front().probability, 10.0 / 11.0, 1e-3);
}

TEST(PoseHypotheses, AreTheSameOnAnyNumberOfThreads) {
  const Particles particles =
      particles_of({{{0.3, 0.2, 0.1}, 0.4, 0.3, 15'000}, {{3.0, 0.0, -3.1}, 0.5, 0.5, 7000}});
  const std::vector<float> weights(22'000, 0.1F);
  const auto alone = find_hypotheses(particles, weights);
  const auto together = find_hypotheses(particles, weights, {}, Workers(3));
  ASSERT_EQ(alone.size(), together.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    ASSERT_EQ(alone[i].T_map_robot.x_m(), together[i].T_map_robot.x_m());
    ASSERT_EQ(alone[i].covariance, together[i].covariance);
    ASSERT_EQ(alone[i].probability, together[i].probability);
  }
}

TEST(PoseHypotheses, AreNoneWithoutWeight) {
  EXPECT_TRUE(find_hypotheses({}, {}).empty());
  EXPECT_TRUE(find_hypotheses(particles_of({{{}, 0.1, 0.1, 10}}), std::vector<float>(10)).empty());
}

}  // namespace
}  // namespace echomap::localization
