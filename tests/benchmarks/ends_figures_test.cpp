// SPDX-License-Identifier: MIT
#include "tests/benchmarks/ends_figures.hpp"

#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

TruthRun ended(bool finished, double coverage, double floor_seen, double sim_seconds) {
  TruthRun run;
  run.finished = finished;
  run.coverage = coverage;
  run.sim_seconds = sim_seconds;
  run.score.fitted.floor_seen = floor_seen;
  return run;
}

std::optional<double> value_of(const std::vector<Figure>& figures, const std::string& name) {
  const auto found = std::find_if(
      figures.begin(), figures.end(), [&](const Figure& figure) { return figure.name == name; });
  return found == figures.end() ? std::nullopt : std::optional(found->value);
}

/// One room that is finished twice of three times, once falsely; one that never is.
std::vector<EndsCell> a_good_and_a_bad_room() {
  EndsCell good{"good", 3, {}, {}};
  good.runs = {ended(true, 0.97, 0.99, 100.0),
               ended(true, 0.97, 0.90, 120.0),
               ended(false, 0.80, 0.85, 50.0)};
  good.peer_runs = {ended(true, 0.96, 0.97, 200.0), ended(true, 0.96, 0.97, 240.0)};
  EndsCell bad{"bad", 3, {ended(false, 0.5, 0.99, 10.0)}, {ended(true, 1.0, 1.0, 5.0)}};
  return {good, bad};
}

TEST(EndsFigures, CountFinishedRunsAndThoseThatAreNot) {
  const auto figures = ends_figures(a_good_and_a_bad_room());
  EXPECT_EQ(value_of(figures, "complete_of_320"), 2.0);
  EXPECT_EQ(value_of(figures, "false_complete_of_320"), 1.0) << "an unfinished run claims nothing";
  EXPECT_EQ(value_of(figures, "complete_least"), 0.0);
  EXPECT_EQ(value_of(figures, "good.false_complete"), 1.0);
  EXPECT_NEAR(*value_of(figures, "coverage_bias"), 0.5 * (-0.02 + 0.07), 1e-12);
  EXPECT_EQ(figures.front().runs, 6U) << "a run without a score counts as unfinished";
}

TEST(EndsFigures, CompareTimesWhereBothFinishHalfOfTheirRuns) {
  const auto figures = ends_figures(a_good_and_a_bad_room());
  EXPECT_EQ(value_of(figures, "time_ratio"), 110.0 / 220.0);
  EXPECT_EQ(value_of(figures, "bad.time_ratio"), std::nullopt);
}

TEST(EndsFigures, TellHowManyMapsAreAsWrongAsTheySay) {
  EndsCell cell{"room", 4, {}, {}};
  for (const double wall_rmse_m : {0.03, 0.045, 0.05, 0.2}) {
    cell.runs.push_back(ended(true, 1.0, 1.0, 10.0));
    cell.runs.back().score.start.map.wall_rmse_m = wall_rmse_m;
    cell.runs.back().expected_wall_rmse_m = 0.04;
    cell.runs.back().wall_rmse_p90_m = 0.08;
  }
  const auto figures = ends_figures({cell});
  EXPECT_EQ(value_of(figures, "walls_within_median"), 0.25);
  EXPECT_EQ(value_of(figures, "walls_within_p90"), 0.75);
  EXPECT_EQ(value_of(ends_figures(a_good_and_a_bad_room()), "walls_within_median"), std::nullopt);
}

TEST(EndsFigures, HaveARowForEachRoom) {
  const MarkdownTable table = ends_table(a_good_and_a_bad_room());
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0][1], "2 of 3");
  EXPECT_EQ(table.rows[0][9], "110 s");
  EXPECT_EQ(table.rows[1][9], "-");
  EXPECT_EQ(table.rows[0].size(), table.header.size());
}

}  // namespace
}  // namespace echomap::bench
