// SPDX-License-Identifier: MIT
#include "host/localization/likelihood_field_model.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "tests/host/localization/corridor.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;

Particles at(std::initializer_list<Pose2> poses) {
  Particles particles;
  particles.resize(poses.size());
  std::size_t i = 0;
  for (const Pose2& pose : poses) {
    particles.set_pose(i, pose);
    particles.log_weight[i++] = 0.0F;
  }
  return particles;
}

TEST(LikelihoodFieldModel, WeighsByTheEndsOfTheReadings) {
  LikelihoodFieldModel model(kCorridor);
  const RangeReading ahead{{}, 1.7};
  model.observe(std::span(&ahead, 1));
  Particles particles = at({{1.2, 0.2, 0.0}, {0.6, 0.2, 0.0}});
  model.make_ready(particles, Workers());
  model.update_weights(0.5F, {0, 2}, particles);
  const LikelihoodField field(kCorridor);
  EXPECT_NEAR(particles.log_weight[0], 0.5 * field.log_likelihood({2.9, 0.2}), 1e-5);
  EXPECT_NEAR(particles.log_weight[1], 0.5 * field.log_likelihood({2.3, 0.2}), 1e-5);
  EXPECT_GT(particles.log_weight[0], particles.log_weight[1]);
}

TEST(LikelihoodFieldModel, HoldsAPoseInAWallAndBeyondTheMapForUnlikely) {
  LikelihoodFieldModel model(kCorridor);
  const RangeReading ahead{{}, 1.0};
  model.observe(std::span(&ahead, 1));
  Particles particles = at({{1.95, 0.05, 0.0}, {9.0, 0.2, 0.0}, {1.95, 0.15, 0.0}});
  model.update_weights(1.0F, {0, 3}, particles);
  EXPECT_LT(particles.log_weight[0], particles.log_weight[2] - 5.0F);
  EXPECT_LT(particles.log_weight[1], particles.log_weight[2] - 5.0F);
}

TEST(LikelihoodFieldModel, HearsNothingInWhatIsNotANumber) {
  LikelihoodFieldModel model(kCorridor);
  const std::array<RangeReading, 3> readings{{{{}, std::nullopt},
                                              {{}, std::numeric_limits<double>::quiet_NaN()},
                                              {{}, std::numeric_limits<double>::infinity()}}};
  model.observe(readings);
  EXPECT_EQ(model.count(), 0U);
}

}  // namespace
}  // namespace echomap::localization
