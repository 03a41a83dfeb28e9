// SPDX-License-Identifier: MIT
#include "host/source_search/leaf_block.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echomap::source_search {
namespace {

ReadingTerms pulses(double count, float dwell_s) {
  ReadingTerms terms;
  terms.value = static_cast<float>(count);
  terms.dwell_s = dwell_s;
  terms.saturated = count > 0.0 ? static_cast<float>(count * std::log(count) - count) : 0.0F;
  return terms;
}

double log_poisson(double count, double mean) {
  return count * std::log(mean) - mean - std::lgamma(count + 1.0);
}

TEST(LeafBlock, IsPoissonsLawWithoutErrorOfTheRate) {
  for (const double count : {0.0, 1.0, 4.0, 30.0}) {
    const double difference =
        static_cast<double>(log_likelihood(pulses(count, 1.0F), 2.5F, 0.5F, 0.0F)) -
        static_cast<double>(log_likelihood(pulses(count, 1.0F), 5.0F, 1.0F, 0.0F));
    EXPECT_NEAR(difference, log_poisson(count, 3.0) - log_poisson(count, 6.0), 1e-3) << count;
  }
}

TEST(LeafBlock, DoublePoissonSumsToOneAndHasTheVarianceThatItSays) {
  const float mean = 20.0F;
  const float relative = 0.1F;
  double sum = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (int count = 0; count < 300; ++count) {
    const double log_saturated = log_poisson(count, std::max(1e-9, static_cast<double>(count)));
    const double probability =
        std::exp(static_cast<double>(log_likelihood(pulses(count, 1.0F), mean, 0.0F, relative)) +
                 log_saturated);
    sum += probability;
    first += count * probability;
    second += static_cast<double>(count) * count * probability;
  }
  const double mean_count = first / sum;
  EXPECT_NEAR(sum, 1.0, 0.05);
  EXPECT_NEAR(mean_count, 20.0, 0.5);
  EXPECT_NEAR(second / sum - mean_count * mean_count, 20.0 + 0.1 * 400.0, 6.0);
}

TEST(LeafBlock, LevelHasANormalDistribution) {
  ReadingTerms level;
  level.value = 7.0F;
  level.variance = 4.0F;
  EXPECT_NEAR(log_likelihood(level, 2.0F, 1.0F, 0.0F) - log_likelihood(level, 6.0F, 1.0F, 0.0F),
              -0.5 * (16.0 / 4.0),
              1e-4);
}

TEST(LeafBlock, RowsOfLanesAreWhatSingleReadingsGive) {
  NuisanceNodes nodes;
  nodes.strengths = {1.0F, 3.0F};
  nodes.backgrounds = {0.2F, 0.4F, 0.8F};
  nodes.shieldings = {{}};
  ResponseLanes lanes;
  for (std::size_t i = 0; i < kLanes; ++i) {
    lanes.response[i] = 0.05F * static_cast<float>(i);
    lanes.variance[i] = 0.01F;
  }
  const ReadingTerms reading = pulses(3.0, 2.0F);
  std::vector<float> rows(nodes.size() * kLanes);
  set_log_likelihoods(reading, lanes, nodes, rows.data());
  for (std::size_t b = 0; b < 3; ++b) {
    for (std::size_t s = 0; s < 2; ++s) {
      for (const std::size_t i : {std::size_t{0}, std::size_t{17}, kLanes - 1}) {
        const float expected = log_likelihood(reading,
                                              2.0F * nodes.strengths[s] * lanes.response[i],
                                              2.0F * nodes.backgrounds[b],
                                              0.01F);
        EXPECT_NEAR(rows[(b * 2 + s) * kLanes + i], expected, 1e-5);
      }
    }
  }
}

TEST(LeafBlock, WhatIsAddedCanBeTakenOut) {
  const std::vector<float> change(2 * kLanes, 1.5F);
  std::vector<float> rows(2 * kLanes, 2.0F);
  add_rows(change, 1.0F, rows.data());
  EXPECT_EQ(rows.back(), 3.5F);
  add_rows(change, -1.0F, rows.data());
  EXPECT_EQ(rows.back(), 2.0F);
}

}  // namespace
}  // namespace echomap::source_search
