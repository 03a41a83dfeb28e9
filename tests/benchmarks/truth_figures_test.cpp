// SPDX-License-Identifier: MIT
#include "tests/benchmarks/truth_figures.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::bench {
namespace {

TruthRun run_with(double free_iou, double solid_called_free, double fitted_iou = 0.9) {
  TruthRun run;
  run.complete = true;
  run.replays_equal = true;
  run.score.start.map.free_iou = free_iou;
  run.score.start.obstacles.solid_called_free = solid_called_free;
  run.score.fitted.map.free_iou = fitted_iou;
  run.score.fit_turn_rad = geometry::radians(-2.0);
  return run;
}

std::optional<Figure> find(const std::vector<Figure>& figures, const std::string& name) {
  const auto found = std::find_if(
      figures.begin(), figures.end(), [&](const Figure& figure) { return figure.name == name; });
  return found != figures.end() ? std::optional(*found) : std::nullopt;
}

std::vector<TruthCell> two_rooms() {
  TruthCell small{"small", true, 20, {}, {}, {}};
  small.runs = {run_with(0.8, 0.1), run_with(0.9, 0.2), run_with(0.95, 0.3)};
  small.rough_runs = {run_with(0.5, 0.5, 0.85)};
  TruthCell large{"large", false, 40, {run_with(0.7, 0.4)}, {}, {}};
  return {small, large};
}

TEST(TruthFigures, AreMediansOverRoomsOfMediansOverSeeds) {
  const auto figures = truth_figures(two_rooms());
  EXPECT_NEAR(find(figures, "free_iou_all")->value, 0.8, 1e-9);
  EXPECT_NEAR(find(figures, "free_iou_small")->value, 0.9, 1e-9);
  EXPECT_NEAR(find(figures, "solid_called_free")->value, 0.3, 1e-9);
  EXPECT_NEAR(find(figures, "solid_called_free_worst")->value, 0.4, 1e-9);
  EXPECT_EQ(find(figures, "free_iou_all")->runs, 4U);
}

TEST(TruthFigures, CompareRoughOdometryByFittedMaps) {
  const auto figures = truth_figures(two_rooms());
  EXPECT_NEAR(find(figures, "rough_free_iou_all")->value, 0.85, 1e-9);
  EXPECT_NEAR(find(figures, "rough_free_iou_all_change")->value, -0.05, 1e-9);
  EXPECT_NEAR(find(figures, "rough_fit_deg")->value, 2.0, 1e-9);
}

TEST(TruthFigures, CountRunsThatReplayEqual) {
  auto rooms = two_rooms();
  rooms.front().runs.front().replays_equal = false;
  EXPECT_EQ(find(truth_figures(rooms), "live_equals_replay_of_320")->value, 3.0);
}

TEST(TruthFigures, LeaveOutWhatNoRoomHasAndSetTheIdealBeside) {
  auto rooms = two_rooms();
  EXPECT_FALSE(find(truth_figures(rooms), "outline_corner_rmse_m"));
  evaluation::PlacedScore ideal;
  ideal.map.free_iou = 0.99;
  rooms.front().ideal = ideal;
  EXPECT_EQ(find(truth_figures(rooms), "free_iou_all")->peers.at("ideal"), 0.99);
  const MarkdownTable table = truth_table(rooms);
  EXPECT_EQ(table.rows.size(), 3U + 1U + 2U);
}

}  // namespace
}  // namespace echomap::bench
