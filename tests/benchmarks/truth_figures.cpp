// SPDX-License-Identifier: MIT
#include "tests/benchmarks/truth_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>

#include <fmt/format.h>

#include "host/geometry/angle.hpp"
#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

using evaluation::PlacedScore;
using evaluation::RunScore;

std::optional<double> share(std::size_t part, std::size_t whole) {
  return whole > 0 ? std::optional(static_cast<double>(part) / static_cast<double>(whole))
                   : std::nullopt;
}

/// Which rooms a figure is of.
enum class Rooms : std::uint8_t { kAll, kSmall };

/// A score, and the figure that is the median of it.
struct Score {
  const char* name;
  const char* unit;
  std::function<std::optional<double>(const PlacedScore&)> value;
  Rooms rooms = Rooms::kAll;
};

std::optional<double> free_iou(const PlacedScore& score) { return score.map.free_iou; }
std::optional<double> wall_rmse_m(const PlacedScore& score) { return score.map.wall_rmse_m; }
std::optional<double> solid_called_free(const PlacedScore& score) {
  return score.obstacles.solid_called_free;
}

/// Off the number of the room's corners, to either side.
std::optional<double> corner_error(const PlacedScore& score) {
  if (!score.outline.corner_rmse_m) {
    return std::nullopt;
  }
  return std::abs(static_cast<double>(score.outline.corners) -
                  static_cast<double>(score.outline.room_corners));
}

const std::vector<Score>& scores() {
  static const std::vector<Score> all{
      {"solid_called_free", "share", solid_called_free},
      {"wall_band_called_free",
       "share",
       [](const PlacedScore& score) { return score.obstacles.wall_band_called_free; }},
      {"objects_found",
       "share",
       [](const PlacedScore& score) {
         return share(score.obstacles.objects_found, score.obstacles.objects);
       }},
      {"path_found_share",
       "share",
       [](const PlacedScore& score) { return share(score.paths.paths, score.paths.pairs); }},
      {"path_collision_share",
       "share",
       [](const PlacedScore& score) { return share(score.paths.collisions, score.paths.paths); }},
      {"free_iou_small", "", free_iou, Rooms::kSmall},
      {"free_iou_all", "", free_iou},
      {"wall_rmse_small_m", "m", wall_rmse_m, Rooms::kSmall},
      {"wall_rmse_all_m", "m", wall_rmse_m},
      {"wall_recall",
       "share",
       [](const PlacedScore& score) { return std::optional(score.map.wall_recall); }},
      {"outline_corner_error", "", corner_error},
      {"outline_corner_rmse_m",
       "m",
       [](const PlacedScore& score) { return score.outline.corner_rmse_m; }},
      {"outline_rmse_m",
       "m",
       [](const PlacedScore& score) { return score.outline.outline_rmse_m; }},
  };
  return all;
}

/// How the maps of a room are placed, and whose they are.
struct Placing {
  const char* prefix;
  std::vector<TruthRun> TruthCell::*runs;
  PlacedScore RunScore::*placed;
};

const std::vector<Placing>& placings() {
  static const std::vector<Placing> all{{"", &TruthCell::runs, &RunScore::start},
                                        {"fitted_", &TruthCell::runs, &RunScore::fitted},
                                        {"rough_", &TruthCell::rough_runs, &RunScore::fitted}};
  return all;
}

std::optional<double> median_or_none(const std::vector<double>& values) {
  return values.empty() ? std::nullopt : std::optional(tests::median(values));
}

std::optional<double> room_median(const TruthCell& cell,
                                  const Score& score,
                                  const Placing& placing) {
  std::vector<double> values;
  for (const TruthRun& run : cell.*placing.runs) {
    if (const auto value = score.value(run.score.*placing.placed)) {
      values.push_back(*value);
    }
  }
  return median_or_none(values);
}

/// One value for each room that has the score.
std::vector<double> room_medians(const std::vector<TruthCell>& cells,
                                 const Score& score,
                                 const Placing& placing) {
  std::vector<double> values;
  for (const TruthCell& cell : cells) {
    const auto value = room_median(cell, score, placing);
    if (value && (score.rooms == Rooms::kAll || cell.is_small)) {
      values.push_back(*value);
    }
  }
  return values;
}

std::vector<double> ideals(const std::vector<TruthCell>& cells, const Score& score) {
  std::vector<double> values;
  for (const TruthCell& cell : cells) {
    const auto value = cell.ideal ? score.value(*cell.ideal) : std::nullopt;
    if (value && (score.rooms == Rooms::kAll || cell.is_small)) {
      values.push_back(*value);
    }
  }
  return values;
}

std::size_t count(const std::vector<TruthCell>& cells,
                  std::vector<TruthRun> TruthCell::*runs,
                  const std::function<bool(const TruthRun&)>& condition) {
  std::size_t sum = 0;
  for (const TruthCell& cell : cells) {
    const auto& list = cell.*runs;
    sum += static_cast<std::size_t>(std::count_if(list.begin(), list.end(), condition));
  }
  return sum;
}

std::size_t count_all(const std::vector<TruthCell>& cells, std::vector<TruthRun> TruthCell::*runs) {
  return count(cells, runs, [](const TruthRun&) { return true; });
}

std::map<std::string, double> as_peer(const std::optional<double>& ideal) {
  return ideal ? std::map<std::string, double>{{"ideal", *ideal}} : std::map<std::string, double>{};
}

void add_scores(const std::vector<TruthCell>& cells,
                const Placing& placing,
                std::vector<Figure>& figures) {
  const std::size_t runs = count_all(cells, placing.runs);
  const std::string prefix = placing.prefix;
  for (const Score& score : scores()) {
    const auto medians = room_medians(cells, score, placing);
    if (medians.empty()) {
      continue;
    }
    const auto best = ideals(cells, score);
    figures.push_back({prefix + score.name,
                       tests::median(medians),
                       score.unit,
                       runs,
                       as_peer(median_or_none(best))});
    if (std::string(score.name) == "solid_called_free") {
      const auto ideal_worst = std::max_element(best.begin(), best.end());
      figures.push_back({prefix + "solid_called_free_worst",
                         *std::max_element(medians.begin(), medians.end()),
                         score.unit,
                         runs,
                         as_peer(best.empty() ? std::nullopt : std::optional(*ideal_worst))});
    }
  }
}

/// How much rough odometry changes the scores of fitted maps.
void add_rough_changes(const std::vector<TruthCell>& cells, std::vector<Figure>& figures) {
  for (const Score& score : scores()) {
    const auto usual = room_medians(cells, score, placings()[1]);
    const auto rough = room_medians(cells, score, placings()[2]);
    if (!usual.empty() && !rough.empty()) {
      figures.push_back({fmt::format("rough_{}_change", score.name),
                         tests::median(rough) - tests::median(usual),
                         score.unit,
                         count_all(cells, &TruthCell::rough_runs),
                         {}});
    }
  }
}

/// Median over rooms of the median turn from one placement to the other.
void add_turns(const std::vector<TruthCell>& cells,
               const char* name,
               std::vector<TruthRun> TruthCell::*runs,
               std::vector<Figure>& figures) {
  std::vector<double> medians;
  for (const TruthCell& cell : cells) {
    std::vector<double> turns_deg;
    for (const TruthRun& run : cell.*runs) {
      turns_deg.push_back(std::abs(geometry::degrees(run.score.fit_turn_rad)));
    }
    if (const auto turn_deg = median_or_none(turns_deg)) {
      medians.push_back(*turn_deg);
    }
  }
  if (!medians.empty()) {
    figures.push_back({name, tests::median(medians), "deg", count_all(cells, runs), {}});
  }
}

void add_counts(const std::vector<TruthCell>& cells,
                const std::string& prefix,
                std::vector<TruthRun> TruthCell::*runs,
                std::vector<Figure>& figures) {
  const std::size_t all = count_all(cells, runs);
  if (all == 0) {
    return;
  }
  const auto add = [&](const char* name, const std::function<bool(const TruthRun&)>& condition) {
    figures.push_back(
        {prefix + name, static_cast<double>(count(cells, runs, condition)), "runs", all, {}});
  };
  add("complete", [](const TruthRun& run) { return run.complete; });
  add("with_hard_collision", [](const TruthRun& run) { return run.hard_collisions > 0; });
  add("live_equals_replay_of_320", [](const TruthRun& run) { return run.replays_equal; });
}

std::string text_of(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "-";
}

/// The columns of the table are the scores of all rooms.
bool is_column(const Score& score) { return score.rooms == Rooms::kAll; }

std::vector<std::string> row_of(const TruthCell& cell, const Placing& placing) {
  const auto& runs = cell.*placing.runs;
  const auto complete =
      std::count_if(runs.begin(), runs.end(), [](const auto& run) { return run.complete; });
  const std::string placed = placing.prefix;
  std::vector<std::string> row{cell.room,
                               placed.empty() ? "first pose" : placed.substr(0, placed.size() - 1),
                               std::to_string(cell.stops),
                               fmt::format("{} of {}", complete, runs.size())};
  for (const Score& score : scores()) {
    if (is_column(score)) {
      row.push_back(text_of(room_median(cell, score, placing)));
    }
  }
  return row;
}

std::vector<std::string> ideal_row_of(const TruthCell& cell, const PlacedScore& ideal) {
  std::vector<std::string> row{cell.room, "ideal", std::to_string(cell.stops), "-"};
  for (const Score& score : scores()) {
    if (is_column(score)) {
      row.push_back(text_of(score.value(ideal)));
    }
  }
  return row;
}

}  // namespace

std::vector<Figure> truth_figures(const std::vector<TruthCell>& cells) {
  std::vector<Figure> figures;
  for (const Placing& placing : placings()) {
    add_scores(cells, placing, figures);
  }
  add_rough_changes(cells, figures);
  add_turns(cells, "fit_deg", &TruthCell::runs, figures);
  add_turns(cells, "rough_fit_deg", &TruthCell::rough_runs, figures);
  add_counts(cells, "", &TruthCell::runs, figures);
  add_counts(cells, "rough_", &TruthCell::rough_runs, figures);
  return figures;
}

std::vector<Figure> room_figures(const TruthCell& cell) {
  std::vector<Figure> figures;
  for (const Placing& placing : placings()) {
    for (const Score& score : scores()) {
      const auto value = is_column(score) ? room_median(cell, score, placing) : std::nullopt;
      if (value) {
        figures.push_back({cell.room + "." + placing.prefix + score.name,
                           *value,
                           score.unit,
                           (cell.*placing.runs).size(),
                           as_peer(cell.ideal ? score.value(*cell.ideal) : std::nullopt)});
      }
    }
  }
  return figures;
}

MarkdownTable truth_table(const std::vector<TruthCell>& cells) {
  MarkdownTable table{{"room", "placed by", "stops", "complete"}, {}};
  for (const Score& score : scores()) {
    if (is_column(score)) {
      table.header.push_back(fmt::format("`{}`", score.name));
    }
  }
  for (const TruthCell& cell : cells) {
    for (const Placing& placing : placings()) {
      if (!(cell.*placing.runs).empty()) {
        table.rows.push_back(row_of(cell, placing));
      }
    }
    if (cell.ideal) {
      table.rows.push_back(ideal_row_of(cell, *cell.ideal));
    }
  }
  return table;
}

}  // namespace echomap::bench
