// SPDX-License-Identifier: MIT
#include "tests/benchmarks/exploration_papers.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace echomap::bench {
namespace {

/// A circle has no corners to be counted.
constexpr const char* kRoundRoom = "round_room";
/// "Walls within 10 mm RMS."
constexpr double kWallsM = 0.010;
/// No place before the door of playground_door is so far from its start.
constexpr double kThroughDoorM = 0.60;
/// A place counts as reached within 30 cm; what the robot has drifted comes on top.
constexpr double kBackM = 0.35;

/// Root mean square over the rooms' corners of all runs that have an outline.
double all_corners_rmse_m(const ExplorationCell& cell) {
  double sum_m2 = 0.0;
  double outlines = 0.0;
  for (const ExplorationRun& run : cell.runs) {
    if (run.corner_rmse_m) {
      sum_m2 += *run.corner_rmse_m * *run.corner_rmse_m;
      outlines += 1.0;
    }
  }
  return outlines > 0.0 ? std::sqrt(sum_m2 / outlines) : 0.0;
}

double most(const ExplorationCell& cell, double (*value)(const ExplorationRun&)) {
  double most = 0.0;
  for (const ExplorationRun& run : cell.runs) {
    most = std::max(most, value(run));
  }
  return most;
}

std::vector<Figure> outline_figures(const ExplorationCell& cell) {
  const auto closed = [](const auto& run) { return run.outcome == "complete"; };
  const auto right = [](const auto& run) { return run.corners == run.room_corners; };
  const auto corners = [](const auto& run) { return static_cast<double>(run.corners); };
  std::vector<Figure> figures{{"outline_closed_of_20", cell.of_20(closed), "", 0, {}},
                              {"outline_corners", cell.median(corners), "", 0, {}}};
  if (cell.entry.what.room != kRoundRoom) {
    const auto off_m = [](const ExplorationRun& run) { return run.corner_rmse_m.value_or(0.0); };
    figures.push_back({"corners_right_of_20", cell.of_20(right), "", 0, {}});
    figures.push_back({"corner_rmse_m", all_corners_rmse_m(cell), "m", 0, {}});
    figures.push_back({"corner_rmse_m_max", most(cell, off_m), "m", 0, {}});
  }
  return figures;
}

std::vector<Figure> field_figures(const ExplorationCell& cell) {
  const auto near = [](const auto& run) { return run.wall_rmse_m.value_or(1.0) <= kWallsM; };
  const auto off_m = [](const ExplorationRun& run) { return run.wall_rmse_m.value_or(1.0); };
  return {{"walls_within_10mm_of_20", cell.of_20(near), "", 0, {}},
          {"wall_rmse_m_max", most(cell, off_m), "m", 0, {}}};
}

std::vector<Figure> door_figures(const ExplorationCell& cell) {
  const auto there_and_back = [](const auto& run) {
    return run.max_distance_from_start_m >= kThroughDoorM && run.end_off_start_m <= kBackM &&
           (run.complete || run.outcome == "waypoints-missed");
  };
  const auto all_phases = [](const auto& run) {
    return run.phases.has_value() && run.phases == run.phases_reached;
  };
  const auto off_m = [](const ExplorationRun& run) { return run.end_off_start_m; };
  return {{"door_to_door_of_20", cell.of_20(there_and_back), "", 0, {}},
          {"all_phases_of_20", cell.of_20(all_phases), "", 0, {}},
          {"end_off_start_m", cell.median(off_m), "m", 0, {}},
          {"end_off_start_m_max", most(cell, off_m), "m", 0, {}}};
}

std::vector<Figure> own_figures(const ExplorationCell& cell) {
  const std::string& strategy = cell.entry.what.strategy;
  if (strategy == "coastal") {
    return outline_figures(cell);
  }
  if (strategy == "epuck") {
    return field_figures(cell);
  }
  return strategy == "tangent-bug" ? door_figures(cell) : std::vector<Figure>{};
}

/// "outline_closed_of_20 20, corner_rmse_m 0.028".
std::string in_words(const std::vector<Figure>& figures) {
  std::string words;
  for (const Figure& figure : figures) {
    words += fmt::format("{}`{}` {:.3g}", words.empty() ? "" : ", ", figure.name, figure.value);
  }
  return words;
}

}  // namespace

std::vector<PaperExperiment> paper_experiments(const std::filesystem::path& folder) {
  std::vector<PaperExperiment> all{{"paper_000", tests::nxt_in_its_room()}};
  for (const char* arena : {"create_l", "create_t", "empty_room", kRoundRoom}) {
    all.push_back({"paper_001", tests::create_in(arena)});
  }
  all.push_back({"paper_001_measured", tests::measured_create_in("create_l", folder)});
  all.push_back({"paper_002", tests::epuck_on_its_field()});
  all.push_back({"paper_003", tests::ev3_at_its_door()});
  all.push_back({"paper_003_brick", tests::brick_at_its_door()});
  all.push_back({"paper_000_brick", tests::brick_in_the_nxts_room()});
  return all;
}

std::vector<Figure> paper_figures(const std::string& paper, const ExplorationCell& cell) {
  std::vector<Figure> figures = own_figures(cell);
  for (Figure& figure : figures) {
    figure.name = fmt::format("{}.{}.{}", paper, cell.entry.what.room, figure.name);
    figure.runs = cell.runs.size();
  }
  return figures;
}

MarkdownTable papers_table(const std::vector<MeasuredPaper>& measured) {
  MarkdownTable table{{"paper", "room", "strategy", "robot"}, {}};
  const auto scores = score_columns();
  table.header.insert(table.header.end(), scores.begin(), scores.end());
  table.header.emplace_back("the paper's own");
  for (const auto& [paper, cell] : measured) {
    const ExplorationCase& what = cell.entry.what;
    const std::string& board = what.board.empty() ? what.emulator : what.board;
    table.rows.push_back({paper, what.room, what.strategy, robot_name(what) + " on " + board});
    const auto texts = score_texts(cell);
    table.rows.back().insert(table.rows.back().end(), texts.begin(), texts.end());
    table.rows.back().push_back(in_words(own_figures(cell)));
  }
  return table;
}

}  // namespace echomap::bench
