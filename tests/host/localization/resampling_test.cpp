// SPDX-License-Identifier: MIT
#include "host/localization/resampling.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

class Resampling : public testing::TestWithParam<ResamplingScheme> {
 protected:
  std::vector<std::size_t> drawn(const std::vector<float>& weights, std::size_t count) {
    std::vector<std::uint32_t> ancestors;
    draw_ancestors(weights, count, GetParam(), random_, ancestors);
    EXPECT_EQ(ancestors.size(), count);
    std::vector<std::size_t> times(weights.size());
    for (const std::uint32_t ancestor : ancestors) {
      ++times.at(ancestor);
    }
    return times;
  }

  std::mt19937 random_{7};
};

TEST_P(Resampling, DrawsEachAsOftenAsItsWeightAsksInTheMean) {
  const std::vector<float> weights{0.1F, 0.0F, 0.4F, 0.25F, 0.2F, 0.05F};
  constexpr int kRounds = 4000;
  std::vector<double> means(weights.size());
  for (int round = 0; round < kRounds; ++round) {
    const auto times = drawn(weights, 10);
    for (std::size_t i = 0; i < times.size(); ++i) {
      means[i] += static_cast<double>(times[i]) / kRounds;
    }
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    EXPECT_NEAR(means[i], 10.0 * static_cast<double>(weights[i]), 0.12) << i;
  }
  EXPECT_EQ(means[1], 0.0);
}

TEST_P(Resampling, DrawsMoreAndFewerThanThereAre) {
  const std::vector<float> weights{1.0F, 2.0F, 3.0F};
  drawn(weights, 1);
  drawn(weights, 1000);
  drawn(weights, 0);
}

TEST_P(Resampling, KeepsTheOnlyOneWithWeight) {
  EXPECT_EQ(drawn({0.0F, 0.0F, 1e-30F, 0.0F}, 50)[2], 50U);
}

std::string name_of(const testing::TestParamInfo<ResamplingScheme>& scheme) {
  const char* const names[] = {"Systematic", "Wheel"};
  return names[static_cast<int>(scheme.param)];
}

INSTANTIATE_TEST_SUITE_P(Schemes,
                         Resampling,
                         testing::Values(ResamplingScheme::kSystematic, ResamplingScheme::kWheel),
                         name_of);

TEST(SystematicResampling, IsNeverAWholeDrawOff) {
  std::mt19937 random(3);
  std::vector<float> weights(200);
  for (float& weight : weights) {
    weight = static_cast<float>(random() % 1000);
  }
  double sum = 0.0;
  for (const float weight : weights) {
    sum += static_cast<double>(weight);
  }
  std::vector<std::uint32_t> ancestors;
  draw_ancestors(weights, 500, ResamplingScheme::kSystematic, random, ancestors);
  for (std::uint32_t i = 0; i < weights.size(); ++i) {
    const auto times = static_cast<double>(std::count(ancestors.begin(), ancestors.end(), i));
    EXPECT_LT(std::abs(times - 500.0 * static_cast<double>(weights[i]) / sum), 1.0001) << i;
  }
}

TEST(SystematicResampling, DrawsTheSameOnAnyNumberOfThreads) {
  std::mt19937 random(5);
  std::vector<float> weights(20 * kBlock + 3);
  for (float& weight : weights) {
    // Whole blocks without weight, and many without a draw.
    weight = random() % 3000 == 0 ? static_cast<float>(random() % 1000) : 0.0F;
  }
  weights[7] = 1.0F;
  std::vector<std::uint32_t> alone;
  std::vector<std::uint32_t> together;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    std::mt19937 one(seed);
    std::mt19937 other(seed);
    draw_ancestors(weights, 9999, ResamplingScheme::kSystematic, one, alone);
    draw_ancestors(weights, 9999, ResamplingScheme::kSystematic, other, together, Workers(3));
    ASSERT_EQ(alone, together);
    ASSERT_TRUE(std::is_sorted(alone.begin(), alone.end()));
    for (const std::uint32_t ancestor : alone) {
      ASSERT_GT(weights[ancestor], 0.0F);
    }
  }
}

WeightSums sums_of(const std::vector<float>& log_weights) {
  Particles particles;
  particles.resize(log_weights.size());
  particles.log_weight = log_weights;
  std::vector<float> weights;
  return relative_weights(particles, weights);
}

TEST(WeightSums, CountAllWhereWeightsAreEqualAndOneWhereItHasAll) {
  EXPECT_DOUBLE_EQ(sums_of(std::vector<float>(1080, -3.0F)).effective_count(), 1080.0);
  EXPECT_DOUBLE_EQ(sums_of({-200.0F, 5.0F, -200.0F}).effective_count(), 1.0);
  EXPECT_DOUBLE_EQ(sums_of({}).effective_count(), 0.0);
}

TEST(WeightSums, KnowTheLogarithmOfTheWhole) {
  EXPECT_NEAR(
      sums_of(std::vector<float>(1080, -300.0F)).log_total(), -300.0 + std::log(1080.0), 1e-5);
  EXPECT_EQ(sums_of({}).log_total(), 0.0);
}

TEST(TakeAncestors, CopiesPosesAndForgetsWeights) {
  Particles before;
  before.resize(3);
  before.set_pose(2, {1.0, 2.0, 0.5});
  before.log_weight = {-1.0F, -2.0F, -3.0F};
  Particles after;
  take_ancestors(before, std::vector<std::uint32_t>{2, 2, 0}, after);
  EXPECT_EQ(after.x_m, (std::vector<float>{1.0F, 1.0F, 0.0F}));
  EXPECT_EQ(after.heading_rad, (std::vector<float>{0.5F, 0.5F, 0.0F}));
  EXPECT_EQ(after.log_weight, (std::vector<float>{0.0F, 0.0F, 0.0F}));
}

TEST(RelativeWeights, AreOneForTheGreatest) {
  Particles particles;
  particles.resize(3);
  particles.log_weight = {-1001.0F, -1000.0F, -1200.0F};
  std::vector<float> weights;
  relative_weights(particles, weights);
  EXPECT_EQ(weights[1], 1.0F);
  EXPECT_NEAR(weights[0], std::exp(-1.0F), 1e-5F);
  EXPECT_EQ(weights[2], 0.0F);
  relative_weights({}, weights);
  EXPECT_TRUE(weights.empty());
}

}  // namespace
}  // namespace echomap::localization
