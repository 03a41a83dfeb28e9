// SPDX-License-Identifier: MIT
#include "tests/benchmarks/team_figures.hpp"

#include <limits>
#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

TeamRun joined_run(const TeamCase& what) {
  TeamRun run;
  run.what = what;
  run.exit = 0;
  run.outcome = "complete";
  run.joined_s = 100.0;
  run.beyond_own_m = 0.01;
  run.pose_error_m = 0.12;
  run.heading_error_rad = 0.02;
  run.free_iou = 0.9;
  run.floor_90_s = 200.0;
  run.floor_seen = 0.95;
  run.kbytes_per_s_per_robot = 0.25;
  return run;
}

/// The single robot takes 400 s.
TeamPair pair_of(const std::string& world, std::size_t robots, int seed) {
  TeamPair pair{joined_run({world, robots, seed}), joined_run({world, 1, seed}), std::nullopt};
  pair.alone.floor_90_s = 400.0;
  return pair;
}

std::optional<double> value(const std::vector<Figure>& figures, const std::string& name) {
  for (const Figure& figure : figures) {
    if (figure.name == name) {
      return figure.value;
    }
  }
  return std::nullopt;
}

TEST(TeamFigures, APlaceIsMergedWhereAllTeamsOfItAre) {
  auto pairs = {pair_of("office", 2, 1), pair_of("office", 4, 1), pair_of("office", 2, 2)};
  EXPECT_EQ(value(team_figures(pairs), "merged_of_120"), 2.0);
  std::vector<TeamPair> one_apart(pairs);
  one_apart[1].team.joined_s.reset();
  EXPECT_EQ(value(team_figures(one_apart), "merged_of_120"), 1.0);
  EXPECT_EQ(value(team_figures(one_apart), "joined.office_4"), 0.0);
  std::vector<TeamPair> one_wrong(pairs);
  one_wrong[2].team.wrong_joins = 2;
  one_wrong[2].team.wrong_joins_left = 1;
  EXPECT_EQ(value(team_figures(one_wrong), "merged_of_120"), 1.0);
  EXPECT_EQ(value(team_figures(one_wrong), "wrong_merges"), 1.0);
  EXPECT_EQ(value(team_figures(one_wrong), "wrong_merges_seen"), 2.0);
}

TEST(TeamFigures, AMergedMapThatIsOffIsNotRight) {
  std::vector<TeamPair> pairs{pair_of("office", 2, 1), pair_of("office", 2, 2)};
  pairs[0].team.beyond_own_m = 0.08;
  pairs[1].team.heading_error_rad = 0.08;
  const auto figures = team_figures(pairs);
  EXPECT_EQ(value(figures, "merged_of_120"), 2.0);
  EXPECT_EQ(value(figures, "merged_right_of_120"), 0.0);
  EXPECT_EQ(value(figures, "pose_error_beyond_own_m"), 0.08);
}

TEST(TeamFigures, ATeamThatNeverHadTheFloorTookForEver) {
  std::vector<TeamPair> pairs{pair_of("ward", 2, 1), pair_of("ward", 2, 2), pair_of("ward", 2, 3)};
  EXPECT_EQ(value(team_figures(pairs), "time_ratio_2_large"), 0.5);
  pairs[0].team.floor_90_s.reset();
  pairs[1].team.floor_90_s.reset();
  EXPECT_EQ(value(team_figures(pairs), "time_ratio_2_large"),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(value(team_figures(pairs), "floor_90.ward_2"), 1.0);
  pairs[2].alone.floor_90_s.reset();
  EXPECT_EQ(value(team_figures(pairs), "floor_90_alone.ward_2"), 2.0);
  EXPECT_FALSE(value(team_figures(pairs), "time_ratio_4_large"));
}

TEST(TeamFigures, TheExcessIsThatOfTheGroupFarthestFromTheIdeal) {
  std::vector<TeamPair> pairs{pair_of("office", 2, 1), pair_of("corridor_rooms", 2, 1)};
  pairs[0].ideal_ratio = 0.45;
  pairs[1].ideal_ratio = 0.3;
  const auto figures = team_figures(pairs);
  EXPECT_NEAR(value(figures, "time_excess.office_2").value_or(0.0), 0.05, 1e-12);
  EXPECT_NEAR(value(figures, "time_excess_small").value_or(0.0), 0.2, 1e-12);
}

TEST(TeamFigures, ARunThatFailedHasARow) {
  TeamPair failed;
  failed.team.what = {"office", 2, 7};
  failed.alone.what = {"office", 1, 7};
  const auto table = team_table({failed});
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].size(), table.header.size());
  EXPECT_EQ(table.rows[0][2], "7");
  EXPECT_EQ(table.rows[0][4], "-");
  EXPECT_EQ(value(team_figures({failed}), "complete.office_2"), 0.0);
  EXPECT_EQ(value(team_figures({failed}), "merged_of_120"), 0.0);
}

}  // namespace
}  // namespace echomap::bench
