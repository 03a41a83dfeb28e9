// SPDX-License-Identifier: MIT
#include "host/localization/motion_update.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

Particles at(const geometry::Pose2& pose, std::size_t count) {
  Particles particles;
  particles.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    particles.set_pose(i, pose);
  }
  return particles;
}

TEST(MotionUpdate, FollowsOdometryWhereThereIsNoNoise) {
  Particles particles = at({1.0, 2.0, 0.5}, 100);
  move(particles, {0, 100}, {0.3, 2.0, -3.0}, {}, {1, 2});
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const geometry::Pose2 pose = particles.pose(i);
    ASSERT_NEAR(pose.x_m(), 1.0 + 2.0 * std::cos(0.8), 1e-5);
    ASSERT_NEAR(pose.y_m(), 2.0 + 2.0 * std::sin(0.8), 1e-5);
    ASSERT_NEAR(pose.heading_rad(), 0.8 - 3.0, 1e-5);
  }
}

class NoiseOfAMotion : public testing::TestWithParam<NoiseShape> {};
INSTANTIATE_TEST_SUITE_P(Shapes,
                         NoiseOfAMotion,
                         testing::Values(NoiseShape::kNormal, NoiseShape::kUniformSum));

TEST_P(NoiseOfAMotion, SpreadsAsTheModelSays) {
  constexpr std::size_t kCount = 100'000;
  Particles particles = at({}, kCount);
  move(particles, {0, kCount}, {0.0, 1.0, 0.0}, {0.0, 0.2, 0.1, 0.05}, {3, 4}, GetParam());
  double x = 0.0;
  double xx = 0.0;
  double yy = 0.0;
  double turns = 0.0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const geometry::Pose2 pose = particles.pose(i);
    x += pose.x_m() / kCount;
    xx += (pose.x_m() - 1.0) * (pose.x_m() - 1.0) / kCount;
    yy += pose.y_m() * pose.y_m() / kCount;
    turns += pose.heading_rad() * pose.heading_rad() / kCount;
  }
  EXPECT_NEAR(x, 1.0, 0.003);
  EXPECT_NEAR(std::sqrt(xx), 0.2, 0.002);
  EXPECT_NEAR(std::sqrt(yy), 0.05, 0.001);
  EXPECT_NEAR(std::sqrt(turns), 0.1, 0.002);
}

TEST_P(NoiseOfAMotion, ComesToTheSameBitsHoweverTheParticlesAreSharedOut) {
  const models::OdometryStep step{0.2, 0.4, -0.1};
  const models::MotionSpread spread{0.1, 0.1, 0.1, 0.1};
  Particles whole = at({0.5, -0.5, 3.0}, 1003);
  Particles parts = whole;
  move(whole, {0, 1003}, step, spread, {8, 9}, GetParam());
  for (const ParticleRange range : {ParticleRange{0, 1}, {1, 18}, {18, 555}, {555, 1003}}) {
    move(parts, range, step, spread, {8, 9}, GetParam());
  }
  EXPECT_EQ(whole.x_m, parts.x_m);
  EXPECT_EQ(whole.y_m, parts.y_m);
  EXPECT_EQ(whole.heading_rad, parts.heading_rad);
}

}  // namespace
}  // namespace echomap::localization
