// SPDX-License-Identifier: MIT
#include "tests/benchmarks/landmark_runs.hpp"

#include <gtest/gtest.h>

#include "tests/benchmarks/nxt_places.hpp"
#include "tests/support/real_data.hpp"

// Bounds that hold with room; the figures are those of `./run bench localization`.
namespace echomap::bench {
namespace {

TEST(RealLandmarks, BrennersRobotIsFollowedByItsCylinders) {
  const auto folder = tests::real_data("lego_brenner");
  ECHOMAP_SKIP_WITHOUT(folder);
  const FollowScore score = follow_brenner(folder, false);
  EXPECT_LT(score.mean_m, 0.065);
  EXPECT_GT(score.dead_reckoning_mean_m, 0.4);
  EXPECT_LT(follow_brenner(folder, true).mean_m, 0.03);
}

TEST(RealLandmarks, ALegoKnowsFivePlacesAgain) {
  const auto folder = tests::real_data("nxt_sonar_imperial");
  ECHOMAP_SKIP_WITHOUT(folder);
  EXPECT_EQ(nxt_places_known_again(folder), 5);
}

}  // namespace
}  // namespace echomap::bench
