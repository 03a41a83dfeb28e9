// SPDX-License-Identifier: MIT
#include "tests/benchmarks/exploration_score.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

constexpr const char* kOurs = "frontier";
/// Ends when it is told to, whatever it has seen.
constexpr const char* kEndsByTheClock = "random-bounce";
/// Another strategy counts as a peer in a room where so many of its runs are complete.
constexpr double kCompleteShare = 0.75;
/// A map is about as good as another where its free floor agrees with the truth by this share of
/// the other's.
constexpr double kLikeMapShare = 0.9;
constexpr double kSmallRoomM = 4.05;

bool is_complete(const ExplorationRun& run) { return run.complete; }

double hard_collisions(const ExplorationCell& cell) {
  double hard = 0.0;
  for (const ExplorationRun& run : cell.runs) {
    hard += run.hard_collisions;
  }
  return hard;
}

double median_iou(const ExplorationCell& cell) {
  return cell.median([](const auto& run) { return run.free_iou; });
}

/// A figure's median over rooms; none without a room.
void add_median(const char* name,
                const std::vector<double>& values,
                const char* unit,
                std::size_t runs,
                std::vector<Figure>& figures) {
  if (!values.empty()) {
    figures.push_back({name, tests::median(values), unit, runs, {}});
  }
}

double median_wall_rmse_m(const ExplorationCell& cell) {
  return cell.median([](const auto& run) { return run.wall_rmse_m.value_or(1.0); });
}

double median_recall(const ExplorationCell& cell) {
  return cell.median([](const auto& run) { return run.wall_recall; });
}

double median_seconds(const ExplorationCell& cell) {
  return cell.median([](const auto& run) { return run.sim_seconds; });
}

double median_distance_m(const ExplorationCell& cell) {
  return cell.median([](const auto& run) { return run.distance_m; });
}

/// What frontier's rooms came to.
struct OursOverRooms {
  std::vector<double> ious{};
  std::vector<double> rmses_m{};
  std::vector<double> small_rmses_m{};
  std::vector<double> ratios{};
  std::vector<double> like_ratios{};
  std::size_t runs = 0;
  int gentle = 0;

  void add(const ExplorationCell& ours, const std::vector<ExplorationCell>& cells) {
    runs += ours.runs.size();
    gentle += ours.count([](const auto& run) { return run.hard_collisions == 0; });
    ious.push_back(median_iou(ours));
    rmses_m.push_back(median_wall_rmse_m(ours));
    if (ours.entry.room_edge_m <= kSmallRoomM) {
      small_rmses_m.push_back(rmses_m.back());
    }
    if (const auto* peer = best_peer(cells, ours.entry.what.room)) {
      ratios.push_back(median_seconds(ours) / median_seconds(*peer));
    }
    const double min_iou = kLikeMapShare * median_iou(ours);
    if (const auto* peer = best_peer(cells, ours.entry.what.room, min_iou)) {
      like_ratios.push_back(median_seconds(ours) / median_seconds(*peer));
    }
  }
};

}  // namespace

int ExplorationCell::count(const std::function<bool(const ExplorationRun&)>& condition) const {
  return static_cast<int>(std::count_if(runs.begin(), runs.end(), condition));
}

double ExplorationCell::of_20(const std::function<bool(const ExplorationRun&)>& condition) const {
  return seeds > 0 ? 20.0 * count(condition) / seeds : 0.0;
}

double ExplorationCell::median(const std::function<double(const ExplorationRun&)>& value) const {
  std::vector<double> values;
  for (const ExplorationRun& run : runs) {
    values.push_back(value(run));
  }
  return values.empty() ? 0.0 : tests::median(values);
}

std::vector<Figure> cell_figures(const ExplorationCell& cell) {
  if (!cell.entry.why_not.empty()) {
    return {};
  }
  const std::string prefix = cell.entry.what.room + "." + cell.entry.what.strategy + ".";
  std::vector<Figure> figures;
  const auto add = [&](const char* name, double value, const char* unit) {
    figures.push_back({prefix + name, value, unit, cell.runs.size(), {}});
  };
  add("complete_of_20", cell.of_20(is_complete), "");
  if (cell.runs.empty()) {
    return figures;
  }
  add("free_iou", median_iou(cell), "");
  add("wall_rmse_m", median_wall_rmse_m(cell), "m");
  add("wall_recall", median_recall(cell), "");
  add("sim_seconds", median_seconds(cell), "s");
  add("distance_m", median_distance_m(cell), "m");
  add("bumps", cell.median([](const auto& run) { return static_cast<double>(run.bumps); }), "");
  add("hard_collisions", hard_collisions(cell), "");
  return figures;
}

const ExplorationCell* best_peer(const std::vector<ExplorationCell>& cells,
                                 const std::string& room,
                                 double min_free_iou) {
  const ExplorationCell* best = nullptr;
  for (const ExplorationCell& cell : cells) {
    const ExplorationCase& what = cell.entry.what;
    const bool counts = what.room == room && what.strategy != kOurs &&
                        what.strategy != kEndsByTheClock && !cell.runs.empty() &&
                        cell.count(is_complete) >= kCompleteShare * cell.seeds &&
                        median_iou(cell) >= min_free_iou;
    if (counts && (best == nullptr || median_seconds(cell) < median_seconds(*best))) {
      best = &cell;
    }
  }
  return best;
}

std::vector<Figure> frontier_figures(const std::vector<ExplorationCell>& cells) {
  std::vector<Figure> figures;
  OursOverRooms all;
  for (const ExplorationCell& cell : cells) {
    if (cell.entry.what.strategy != kOurs || cell.runs.empty()) {
      continue;
    }
    const std::string& room = cell.entry.what.room;
    all.add(cell, cells);
    if (const ExplorationCell* peer = best_peer(cells, room)) {
      figures.push_back({room + ".frontier_seconds",
                         median_seconds(cell),
                         "s",
                         cell.runs.size(),
                         {{peer->entry.what.strategy, median_seconds(*peer)}}});
    }
  }
  add_median("frontier_free_iou", all.ious, "", all.runs, figures);
  add_median("frontier_wall_rmse_m", all.rmses_m, "m", all.runs, figures);
  add_median("frontier_wall_rmse_m_to_4m", all.small_rmses_m, "m", all.runs, figures);
  add_median("frontier_time_ratio", all.ratios, "", all.runs, figures);
  add_median("frontier_time_ratio_to_like_maps", all.like_ratios, "", all.runs, figures);
  if (all.runs > 0) {
    const double share = static_cast<double>(all.gentle) / static_cast<double>(all.runs);
    figures.push_back({"frontier_gentle_share", share, "", all.runs, {}});
  }
  return figures;
}

std::string robot_name(const ExplorationCase& what) {
  return std::filesystem::path(what.robot).stem().string();
}

std::vector<std::string> score_columns() {
  return {
      "complete", "`free_iou`", "`wall_rmse_m`", "`wall_recall`", "time", "way", "hard collisions"};
}

std::vector<std::string> score_texts(const ExplorationCell& cell) {
  std::vector<std::string> texts;
  if (!cell.entry.why_not.empty()) {
    texts = {"not run: " + cell.entry.why_not};
  } else {
    texts = {fmt::format("{} of {}", cell.count(is_complete), cell.seeds)};
    if (!cell.runs.empty()) {
      texts.push_back(fmt::format("{:.3f}", median_iou(cell)));
      const bool has_walls =
          cell.count([](const auto& run) { return run.wall_rmse_m.has_value(); }) > 0;
      texts.push_back(has_walls ? fmt::format("{:.3f}", median_wall_rmse_m(cell)) : "no wall");
      texts.push_back(fmt::format("{:.2f}", median_recall(cell)));
      texts.push_back(fmt::format("{:.0f} s", median_seconds(cell)));
      texts.push_back(fmt::format("{:.1f} m", median_distance_m(cell)));
      texts.push_back(fmt::format("{:.0f}", hard_collisions(cell)));
    }
  }
  texts.resize(score_columns().size());
  return texts;
}

MarkdownTable rooms_table(const std::vector<ExplorationCell>& cells) {
  MarkdownTable table{{"room", "strategy", "robot"}, {}};
  const auto scores = score_columns();
  table.header.insert(table.header.end(), scores.begin(), scores.end());
  for (const ExplorationCell& cell : cells) {
    const ExplorationCase& what = cell.entry.what;
    table.rows.push_back({what.room, what.strategy, robot_name(what)});
    const auto texts = score_texts(cell);
    table.rows.back().insert(table.rows.back().end(), texts.begin(), texts.end());
  }
  return table;
}

}  // namespace echomap::bench
