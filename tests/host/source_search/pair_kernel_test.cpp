// SPDX-License-Identifier: MIT
#include "host/source_search/pair_kernel.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace echomap::source_search {
namespace {

TEST(PairKernel, DistanceIsHalfTheSquareTimesTheDwell) {
  const std::array<float, 3> features{1.0F, 2.0F, 4.0F};
  std::array<float, 3> distances{0.5F, 0.0F, 0.0F};
  add_pair_distances(features.data(), features.size(), 2.0F, 3.0F, distances.data());
  EXPECT_FLOAT_EQ(distances[0], 2.0F);
  EXPECT_FLOAT_EQ(distances[1], 0.0F);
  EXPECT_FLOAT_EQ(distances[2], 6.0F);
}

TEST(PairKernel, SumsWhatIsLeftOfEachWeight) {
  std::array<float, 32> distances{};
  std::array<float, 32> weights{};
  std::array<float, 32> similar{};
  distances[20] = 2.0F;
  weights[3] = 0.25F;
  weights[20] = 0.75F;
  similar[20] = 0.75F;
  const PairSums sums = sum_pairs(distances.data(), similar.data(), weights.data(), 32);
  EXPECT_NEAR(sums.all, 0.25 + 0.75 * std::exp(-2.0), 1e-5);
  EXPECT_NEAR(sums.similar, 0.75 * std::exp(-2.0), 1e-5);
}

}  // namespace
}  // namespace echomap::source_search
