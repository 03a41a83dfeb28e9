// SPDX-License-Identifier: MIT
#include "host/source_search/information_gain.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/source_world.hpp"

namespace echomap::source_search {
namespace {

/// Two places and none, in a room without readings.
class InformationGainTest : public testing::Test {
 protected:
  InformationGainTest() : belief_({}, tests::SourceWorld({6.0, 3.0}, {}).map()) {}

  InformationGain gain() const {
    return InformationGain(belief_,
                           {{0.5, std::nullopt, 0.0, 0.0, 0.4, {}},
                            {0.25, Eigen::Vector2d(1.0, 1.5), 0.05, 5.0, 0.4, {}},
                            {0.25, Eigen::Vector2d(5.0, 1.5), 0.05, 5.0, 0.4, {}}});
  }
  double after(const std::vector<PlannedDwell>& dwells) const {
    const InformationGain gain = this->gain();
    PairDistances distances = gain.no_reading();
    for (const PlannedDwell& dwell : dwells) {
      gain.add(dwell, distances);
    }
    return gain.expected_log_probability(distances);
  }

  SourceBelief belief_;
};

TEST_F(InformationGainTest, BeginsWithTheEntropyOfTheClaims) {
  EXPECT_NEAR(after({}), 0.5 * std::log(0.5) + 0.5 * std::log(0.25), 1e-4);
}

TEST_F(InformationGainTest, EndsWhereAllIsKnown) {
  EXPECT_NEAR(after({{{1.2, 1.5}, 1000.0}, {{4.8, 1.5}, 1000.0}}), 0.0, 1e-3);
}

TEST_F(InformationGainTest, LongerDwellsGainMore) {
  EXPECT_GT(after({{{1.5, 1.5}, 2.0}}), after({{{1.5, 1.5}, 1.0}}));
  EXPECT_GT(after({{{1.5, 1.5}, 1.0}}), after({}));
}

TEST_F(InformationGainTest, NearPlacesGainMore) {
  EXPECT_GT(after({{{1.2, 1.5}, 1.0}}), after({{{2.0, 1.5}, 1.0}}));
}

TEST_F(InformationGainTest, WhatAnotherReadsIsNotWorthMuchTwice) {
  const PlannedDwell others{{1.2, 1.5}, 2.0};
  const double alone = after({others});
  const double same_gain = after({others, {{1.2, 1.4}, 2.0}}) - alone;
  const double other_gain = after({others, {{4.8, 1.5}, 2.0}}) - alone;
  EXPECT_GT(other_gain, 3.0 * same_gain);
}

TEST_F(InformationGainTest, PlacesWithinTheRadiusAreOneClaim) {
  const InformationGain near(belief_,
                             {{0.5, Eigen::Vector2d(1.0, 1.5), 0.05, 5.0, 0.4, {}},
                              {0.5, Eigen::Vector2d(1.1, 1.5), 0.05, 9.0, 0.4, {}}});
  EXPECT_NEAR(near.expected_log_probability(near.no_reading()), 0.0, 1e-6);
}

TEST_F(InformationGainTest, WhatIsImpossibleDoesNotCount) {
  const InformationGain gain(belief_,
                             {{0.0, std::nullopt, 0.0, 0.0, 0.4, {}},
                              {0.5, Eigen::Vector2d(1.0, 1.5), 0.05, 5.0, 0.4, {}},
                              {0.5, Eigen::Vector2d(5.0, 1.5), 0.05, 5.0, 0.4, {}}});
  EXPECT_NEAR(gain.expected_log_probability(gain.no_reading()), std::log(0.5), 1e-4);
}

}  // namespace
}  // namespace echomap::source_search
