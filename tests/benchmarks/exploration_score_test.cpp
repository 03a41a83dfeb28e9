// SPDX-License-Identifier: MIT
#include "tests/benchmarks/exploration_score.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/benchmarks/exploration_papers.hpp"

namespace echomap::bench {
namespace {

using testing::HasSubstr;

ExplorationRun run_of(bool complete, double seconds, double free_iou = 0.9) {
  ExplorationRun run;
  run.complete = complete;
  run.outcome = complete ? "complete" : "stop-limit";
  run.sim_seconds = seconds;
  run.free_iou = free_iou;
  run.wall_rmse_m = 0.03;
  return run;
}

ExplorationCell cell_of(const std::string& strategy, const std::vector<ExplorationRun>& runs) {
  ExplorationEntry entry{{"hall", strategy, "uno_2wd"}};
  entry.room_edge_m = 6.0;
  return {entry, static_cast<int>(runs.size()), runs};
}

double figure(const std::vector<Figure>& figures, const std::string& name) {
  for (const Figure& figure : figures) {
    if (figure.name == name) {
      return figure.value;
    }
  }
  ADD_FAILURE() << "no figure " << name;
  return 0.0;
}

bool has(const std::vector<Figure>& figures, const std::string& name) {
  for (const Figure& figure : figures) {
    if (figure.name == name) {
      return true;
    }
  }
  return false;
}

TEST(BestPeer, IsTheFastestThatIsNotOurs) {
  const std::vector<ExplorationCell> cells{cell_of("frontier", {run_of(true, 10.0)}),
                                           cell_of("coastal", {run_of(true, 300.0)}),
                                           cell_of("nxt-farthest", {run_of(true, 200.0)})};
  EXPECT_EQ(best_peer(cells, "hall"), &cells[2]);
  EXPECT_EQ(best_peer(cells, "office"), nullptr);
}

TEST(BestPeer, IsCompleteInThreeOfFourSeeds) {
  const auto done = run_of(true, 100.0);
  const auto not_done = run_of(false, 100.0);
  const std::vector<ExplorationCell> three{cell_of("coastal", {done, done, done, not_done})};
  EXPECT_EQ(best_peer(three, "hall"), &three[0]);
  const std::vector<ExplorationCell> two{cell_of("coastal", {done, done, not_done, not_done})};
  EXPECT_EQ(best_peer(two, "hall"), nullptr);
}

TEST(BestPeer, CountsRunsThatDidNotEndAsNotComplete) {
  auto cell = cell_of("coastal", {run_of(true, 100.0)});
  cell.seeds = 2;
  EXPECT_EQ(best_peer({cell}, "hall"), nullptr);
  EXPECT_DOUBLE_EQ(figure(cell_figures(cell), "hall.coastal.complete_of_20"), 10.0);
}

TEST(BestPeer, IsNotOneThatEndsByTheClock) {
  EXPECT_EQ(best_peer({cell_of("random-bounce", {run_of(true, 20.0)})}, "hall"), nullptr);
}

TEST(FrontierFigures, CompareWithTheFastestAndWithTheFastestOfLikeMaps) {
  const std::vector<ExplorationCell> cells{cell_of("frontier", {run_of(true, 60.0, 0.95)}),
                                           cell_of("nxt-farthest", {run_of(true, 100.0, 0.40)}),
                                           cell_of("tangent-bug", {run_of(true, 200.0, 0.90)})};
  const auto figures = frontier_figures(cells);
  EXPECT_DOUBLE_EQ(figure(figures, "frontier_time_ratio"), 0.6);
  EXPECT_DOUBLE_EQ(figure(figures, "frontier_time_ratio_to_like_maps"), 0.3);
  EXPECT_DOUBLE_EQ(figure(figures, "frontier_free_iou"), 0.95);
}

TEST(FrontierFigures, HaveNoRatioWithoutAPeer) {
  const auto figures = frontier_figures({cell_of("frontier", {run_of(true, 60.0)})});
  EXPECT_FALSE(has(figures, "frontier_time_ratio"));
  EXPECT_TRUE(has(figures, "frontier_wall_rmse_m"));
  EXPECT_FALSE(has(figures, "frontier_wall_rmse_m_to_4m")) << "the hall is larger";
}

TEST(FrontierFigures, CountRunsWithoutAHardCollision) {
  auto hard = run_of(true, 60.0);
  hard.hard_collisions = 3;
  const auto figures = frontier_figures({cell_of("frontier", {run_of(true, 60.0), hard})});
  EXPECT_DOUBLE_EQ(figure(figures, "frontier_gentle_share"), 0.5);
}

TEST(RoomsTable, NamesTheRobotAndWhyAStrategyDidNotRun) {
  auto absent = cell_of("coastal", {});
  absent.entry.why_not = "too large";
  const auto table = rooms_table({cell_of("frontier", {run_of(true, 61.0)}), absent});
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_THAT(to_markdown(table),
              HasSubstr("| hall | frontier | uno_2wd | 1 of 1 | 0.900 | 0.030 | 0.00 | 61 s |"));
  EXPECT_EQ(table.rows[1][3], "not run: too large");
  EXPECT_TRUE(cell_figures(absent).empty());
}

TEST(PaperFigures, CountClosedOutlinesAndTheirCorners) {
  auto right = run_of(true, 200.0);
  right.corners = right.room_corners = 6;
  right.corner_rmse_m = 0.03;
  auto wrong = right;
  wrong.corners = 7;
  wrong.corner_rmse_m = 0.04;
  wrong.outcome = "stop-limit";
  const auto figures = paper_figures("paper_001", cell_of("coastal", {right, wrong}));
  EXPECT_DOUBLE_EQ(figure(figures, "paper_001.hall.outline_closed_of_20"), 10.0);
  EXPECT_DOUBLE_EQ(figure(figures, "paper_001.hall.corners_right_of_20"), 10.0);
  EXPECT_NEAR(figure(figures, "paper_001.hall.corner_rmse_m"), 0.03536, 1e-5);
  EXPECT_DOUBLE_EQ(figure(figures, "paper_001.hall.corner_rmse_m_max"), 0.04);
}

TEST(PaperFigures, CountNoCornersInARoundRoom) {
  auto cell = cell_of("coastal", {run_of(true, 200.0)});
  cell.entry.what.room = "round_room";
  const auto figures = paper_figures("paper_001", cell);
  EXPECT_FALSE(has(figures, "paper_001.round_room.corners_right_of_20"));
  EXPECT_TRUE(has(figures, "paper_001.round_room.outline_closed_of_20"));
}

TEST(PaperFigures, BelieveNobodyWhoNeverLeftTheForecourt) {
  auto through = run_of(false, 250.0);
  through.outcome = "waypoints-missed";
  through.phases = 7;
  through.phases_reached = 6;
  through.max_distance_from_start_m = 2.2;
  through.end_off_start_m = 0.1;
  auto stayed = through;
  stayed.max_distance_from_start_m = 0.4;
  auto astray = through;
  astray.end_off_start_m = 0.5;
  const auto figures =
      paper_figures("paper_003", cell_of("tangent-bug", {through, stayed, astray}));
  EXPECT_NEAR(figure(figures, "paper_003.hall.door_to_door_of_20"), 20.0 / 3.0, 1e-9);
  EXPECT_DOUBLE_EQ(figure(figures, "paper_003.hall.all_phases_of_20"), 0.0);
}

}  // namespace
}  // namespace echomap::bench
