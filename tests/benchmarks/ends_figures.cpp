// SPDX-License-Identifier: MIT
#include "tests/benchmarks/ends_figures.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

bool is_falsely_finished(const TruthRun& run) {
  return run.finished && run.score.fitted.floor_seen < kTrulyFinishedShare;
}

std::size_t finished_of(const std::vector<TruthRun>& runs) {
  return static_cast<std::size_t>(
      std::count_if(runs.begin(), runs.end(), [](const TruthRun& run) { return run.finished; }));
}

std::size_t falsely_finished_of(const std::vector<TruthRun>& runs) {
  return static_cast<std::size_t>(std::count_if(runs.begin(), runs.end(), is_falsely_finished));
}

/// Empty where fewer than half of the runs are finished.
std::optional<double> time_of_finished_s(const std::vector<TruthRun>& runs, std::size_t seeds) {
  std::vector<double> times_s;
  for (const TruthRun& run : runs) {
    if (run.finished) {
      times_s.push_back(run.sim_seconds);
    }
  }
  return !times_s.empty() && 2 * times_s.size() >= seeds ? std::optional(tests::median(times_s))
                                                         : std::nullopt;
}

/// The share of the runs of all rooms that tell of their walls and are at most so wrong.
std::optional<Figure> walls_within(const std::vector<EndsCell>& cells,
                                   const char* name,
                                   std::optional<double> TruthRun::*told_m) {
  std::size_t told = 0;
  std::size_t within = 0;
  for (const EndsCell& cell : cells) {
    for (const TruthRun& run : cell.runs) {
      const auto& wall_rmse_m = run.score.start.map.wall_rmse_m;
      if (run.*told_m && wall_rmse_m) {
        ++told;
        within += *wall_rmse_m <= *(run.*told_m) ? 1 : 0;
      }
    }
  }
  return told == 0 ? std::nullopt
                   : std::optional(Figure{name,
                                          static_cast<double>(within) / static_cast<double>(told),
                                          "share",
                                          told,
                                          {}});
}

std::optional<double> time_ratio_of(const EndsCell& cell) {
  const auto time_s = time_of_finished_s(cell.runs, cell.seeds);
  const auto peer_s = time_of_finished_s(cell.peer_runs, cell.seeds);
  return time_s && peer_s ? std::optional(*time_s / *peer_s) : std::nullopt;
}

/// Of the runs that have a value.
template <class Value>
std::string median_text(const std::vector<TruthRun>& runs, const char* format, Value&& value) {
  std::vector<double> values;
  for (const TruthRun& run : runs) {
    if (const std::optional<double> of_run = value(run)) {
      values.push_back(*of_run);
    }
  }
  return values.empty() ? "-" : fmt::format(fmt::runtime(format), tests::median(values));
}

std::string text_of(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

}  // namespace

std::vector<Figure> ends_figures(const std::vector<EndsCell>& cells) {
  std::size_t runs = 0;
  std::size_t complete = 0;
  std::size_t falsely = 0;
  double least = 1.0;
  double bias = 0.0;
  std::vector<double> ratios;
  std::vector<Figure> of_rooms;
  for (const EndsCell& cell : cells) {
    const auto finished = finished_of(cell.runs);
    runs += cell.seeds;
    complete += finished;
    falsely += falsely_finished_of(cell.runs);
    const double share = static_cast<double>(finished) / static_cast<double>(cell.seeds);
    least = std::min(least, share);
    for (const TruthRun& run : cell.runs) {
      bias += run.finished ? run.coverage - run.score.fitted.floor_seen : 0.0;
    }
    of_rooms.push_back({cell.room + ".complete", share, "share", cell.seeds, {}});
    of_rooms.push_back({cell.room + ".false_complete",
                        static_cast<double>(falsely_finished_of(cell.runs)),
                        "",
                        cell.seeds,
                        {}});
    if (const auto ratio = time_ratio_of(cell)) {
      ratios.push_back(*ratio);
      of_rooms.push_back({cell.room + ".time_ratio", *ratio, "", cell.seeds, {}});
    }
  }
  std::vector<Figure> figures{
      {"complete_of_320", static_cast<double>(complete), "", runs, {}},
      {"complete_least", least, "share", runs, {}},
      {"false_complete_of_320", static_cast<double>(falsely), "", runs, {}}};
  if (complete > 0) {
    figures.push_back({"coverage_bias", bias / static_cast<double>(complete), "", complete, {}});
  }
  for (const auto& share :
       {walls_within(cells, "walls_within_median", &TruthRun::expected_wall_rmse_m),
        walls_within(cells, "walls_within_p90", &TruthRun::wall_rmse_p90_m)}) {
    if (share) {
      figures.push_back(*share);
    }
  }
  if (!ratios.empty()) {
    figures.push_back({"time_ratio", tests::median(ratios), "", ratios.size(), {}});
  }
  figures.insert(figures.end(), of_rooms.begin(), of_rooms.end());
  return figures;
}

MarkdownTable ends_table(const std::vector<EndsCell>& cells) {
  MarkdownTable table{{"room",
                       "complete",
                       "falsely",
                       "`coverage`",
                       "`floor_seen`",
                       "`free_iou`",
                       "`wall_rmse_m`",
                       "expected",
                       "stops",
                       "robot time",
                       "nxt-farthest"},
                      {}};
  for (const EndsCell& cell : cells) {
    table.rows.push_back(
        {cell.room,
         fmt::format("{} of {}", finished_of(cell.runs), cell.seeds),
         std::to_string(falsely_finished_of(cell.runs)),
         median_text(cell.runs, "{:.2f}", [](const TruthRun& run) { return run.coverage; }),
         median_text(
             cell.runs, "{:.2f}", [](const TruthRun& run) { return run.score.fitted.floor_seen; }),
         median_text(
             cell.runs, "{:.3f}", [](const TruthRun& run) { return run.score.start.map.free_iou; }),
         median_text(cell.runs,
                     "{:.3f}",
                     [](const TruthRun& run) { return run.score.start.map.wall_rmse_m; }),
         median_text(
             cell.runs, "{:.3f}", [](const TruthRun& run) { return run.expected_wall_rmse_m; }),
         median_text(cell.runs,
                     "{:.0f}",
                     [](const TruthRun& run) { return static_cast<double>(run.stops); }),
         text_of(time_of_finished_s(cell.runs, cell.seeds), "{:.0f} s"),
         text_of(time_of_finished_s(cell.peer_runs, cell.seeds), "{:.0f} s")});
  }
  return table;
}

}  // namespace echomap::bench
