// SPDX-License-Identifier: MIT
#include "host/source_search/block_posterior.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/source_world.hpp"

namespace echomap::source_search {
namespace {

HypothesisGrid grid_with_pulses() {
  HypothesisGrid grid({}, tests::SourceWorld({2.0, 2.0}, {}).map());
  const std::vector<FieldReading> readings{{{0.5, 0.5}, 30.0, 2.0, 0.0},
                                           {{1.5, 1.5}, 5.0, 2.0, 0.0}};
  grid.add(readings);
  return grid;
}

TEST(BlockPosterior, PlacesAndBackgroundsHoldTheSameProbability) {
  const HypothesisGrid grid = grid_with_pulses();
  const auto posterior = posterior_of(grid, grid.blocks()[0], 0.1, -5.0);
  double places = 0.0;
  for (const double place : posterior.place) {
    places += place;
  }
  double backgrounds = 0.0;
  for (const double background : posterior.background) {
    backgrounds += background;
  }
  EXPECT_GT(places, 0.0);
  EXPECT_NEAR(backgrounds / places, 1.0, 1e-9);
}

TEST(BlockPosterior, IsRelativeToItsReference) {
  const HypothesisGrid grid = grid_with_pulses();
  const auto one = posterior_of(grid, grid.blocks()[0], 0.1, -5.0);
  const auto other = posterior_of(grid, grid.blocks()[0], 0.1, -6.0);
  EXPECT_NEAR(other.place[0] / one.place[0], std::exp(1.0), 1e-9);
}

TEST(BlockPosterior, MorePulsesAreSummedInFinerSteps) {
  HypothesisGrid grid({}, tests::SourceWorld({2.0, 2.0}, {}).map());
  const std::size_t before = integral_for(grid, grid.blocks()[0]).steps().size();
  const std::vector<FieldReading> readings{{{0.5, 0.5}, 400.0, 2.0, 0.0}};
  grid.add(readings);
  EXPECT_GT(integral_for(grid, grid.blocks()[0]).steps().size(), 3 * before);
}

TEST(BlockPosterior, NuisancesOfAPlaceSumToOneAndFitThePulses) {
  const HypothesisGrid grid = grid_with_pulses();
  const auto shares = nuisances_of(grid, {0, 0});
  double sum = 0.0;
  double mean_log_strength = 0.0;
  for (const NuisanceShare& share : shares) {
    sum += share.probability;
    mean_log_strength += share.probability * std::log(share.strength);
  }
  EXPECT_NEAR(sum, 1.0, 1e-6);
  // 15 pulses a second in a distance of 0.5 m or more.
  EXPECT_GT(mean_log_strength, std::log(2.0));
}

}  // namespace
}  // namespace echomap::source_search
