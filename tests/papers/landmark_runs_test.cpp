// SPDX-License-Identifier: MIT
#include "tests/benchmarks/landmark_runs.hpp"

#include <gtest/gtest.h>

#include "tests/benchmarks/nxt_places.hpp"
#include "tests/support/real_data.hpp"

// Bounds that hold with room; the figures are those of `./run bench localization`.
namespace echomap::bench {
namespace {

TEST(RealLandmarks, MrclamsRobotsAreFollowedAloneAndBetterAsATeam) {
  const auto folder = tests::real_data("utias_mrclam/MRCLAM_Dataset6");
  ECHOMAP_SKIP_WITHOUT(folder);
  const auto alone = follow_mrclam(folder, false);
  const auto team = follow_mrclam(folder, true);
  ASSERT_EQ(alone.size(), 5U);
  double alone_m = 0.0;
  double team_m = 0.0;
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_LT(team[i].rmse_m, 0.15) << "robot " << i + 1;
    EXPECT_LT(team[i].rmse_m, 0.2 * alone[i].dead_reckoning_mean_m) << "robot " << i + 1;
    EXPECT_GT(team[i].poses, 45000U);
    EXPECT_LT(team[i].gated, 100U);
    alone_m += alone[i].rmse_m / 5.0;
    team_m += team[i].rmse_m / 5.0;
  }
  EXPECT_LT(team_m, 0.12);
  EXPECT_LT(team_m, 0.9 * alone_m);
}

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
