// SPDX-License-Identifier: MIT
#include "tests/benchmarks/team_figures.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/geometry/angle.hpp"
#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

constexpr double kRightM = 0.05;
constexpr double kRightDeg = 4.0;
constexpr const char* kLarge = "ward";

std::string cell(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

std::optional<double> degrees_of(const std::optional<double>& rad) {
  return rad ? std::optional(geometry::degrees(*rad)) : std::nullopt;
}

std::vector<std::string> row_of(const TeamRun& run, const std::string& ratio) {
  return {run.what.world,
          std::to_string(run.what.robots),
          std::to_string(run.what.seed),
          run.exit ? std::to_string(*run.exit) : "-",
          run.outcome.empty() ? "-" : run.outcome,
          cell(run.joined_s, "{:.0f}"),
          cell(run.pose_error_m, "{:.2f}"),
          cell(run.beyond_own_m, "{:+.2f}"),
          cell(degrees_of(run.heading_error_rad), "{:.1f}"),
          fmt::format("{}/{}", run.wrong_joins, run.wrong_joins_left),
          cell(run.free_iou, "{:.3f}"),
          cell(run.solid_called_free, "{:.3f}"),
          fmt::format("{:.2f}", run.floor_seen),
          cell(run.floor_90_s, "{:.0f}"),
          ratio,
          fmt::format("{:.0f}", run.sim_seconds),
          fmt::format("{}/{}", run.bumps, run.hard_collisions),
          fmt::format("{}/{}", run.deadlocks, run.deadlocks_left),
          cell(run.kbytes_per_s_per_robot, "{:.2f}"),
          fmt::format("{:.0f}", run.wall_s),
          fmt::format("{:.0f}", run.cpu_s),
          fmt::format("{}", fmt::join(run.endings, ", "))};
}

std::string ratio_of(const TeamPair& pair) {
  const auto ratio = pair.time_ratio();
  if (!ratio) {
    return "-";
  }
  return pair.ideal_ratio ? fmt::format("{:.2f} ({:.2f})", *ratio, *pair.ideal_ratio)
                          : fmt::format("{:.2f}", *ratio);
}

using Pick = std::function<std::optional<double>(const TeamPair&)>;

std::vector<double> picked(const std::vector<TeamPair>& pairs, const Pick& pick) {
  std::vector<double> values;
  for (const TeamPair& pair : pairs) {
    if (const auto value = pick(pair)) {
      values.push_back(*value);
    }
  }
  return values;
}

/// Those of a world and a number of robots.
using Groups = std::map<std::pair<std::string, std::size_t>, std::vector<TeamPair>>;

Groups grouped(const std::vector<TeamPair>& pairs) {
  Groups groups;
  for (const TeamPair& pair : pairs) {
    groups[{pair.team.what.world, pair.team.what.robots}].push_back(pair);
  }
  return groups;
}

bool is_right(const TeamRun& run) {
  return run.is_joined() && run.beyond_own_m.value_or(1.0) <= kRightM &&
         degrees_of(run.heading_error_rad).value_or(180.0) <= kRightDeg;
}

void add_merging(const std::vector<TeamPair>& pairs, std::vector<Figure>& figures) {
  std::map<std::pair<std::string, int>, std::pair<bool, bool>> places;
  double wrong = 0.0;
  double wrong_seen = 0.0;
  std::optional<double> beyond_m;
  for (const TeamPair& pair : pairs) {
    const TeamRun& team = pair.team;
    auto& [merged, right] =
        places.try_emplace({team.what.world, team.what.seed}, true, true).first->second;
    merged = merged && team.is_joined();
    right = right && is_right(team);
    wrong += static_cast<double>(team.wrong_joins_left);
    wrong_seen += static_cast<double>(team.wrong_joins);
    if (team.is_joined() && team.beyond_own_m) {
      beyond_m = std::max(beyond_m.value_or(*team.beyond_own_m), *team.beyond_own_m);
    }
  }
  const auto count = [&](auto member) {
    return static_cast<double>(
        std::ranges::count_if(places, [&](const auto& place) { return place.second.*member; }));
  };
  figures.push_back({"merged_of_120", count(&std::pair<bool, bool>::first), "", places.size(), {}});
  figures.push_back(
      {"merged_right_of_120", count(&std::pair<bool, bool>::second), "", places.size(), {}});
  if (beyond_m) {
    figures.push_back({"pose_error_beyond_own_m", *beyond_m, "m", pairs.size(), {}});
  }
  figures.push_back({"wrong_merges", wrong, "", pairs.size(), {}});
  figures.push_back({"wrong_merges_seen", wrong_seen, "", pairs.size(), {}});
}

void add_median(const std::string& name,
                const std::vector<double>& values,
                const char* unit,
                std::vector<Figure>& figures) {
  if (!values.empty()) {
    figures.push_back({name, tests::median(values), unit, values.size(), {}});
  }
}

/// By how much the median ratio is above that of the ideal, of the group where it is most.
void add_excess(const Groups& groups, std::vector<Figure>& figures) {
  std::optional<Figure> worst;
  for (const auto& [group, pairs] : groups) {
    std::vector<TeamPair> comparable;
    std::ranges::copy_if(pairs, std::back_inserter(comparable), [](const TeamPair& pair) {
      return pair.time_ratio() && pair.ideal_ratio;
    });
    if (comparable.empty()) {
      continue;
    }
    const double excess =
        tests::median(picked(comparable, [](const TeamPair& pair) { return pair.time_ratio(); })) -
        tests::median(picked(comparable, [](const TeamPair& pair) { return pair.ideal_ratio; }));
    figures.push_back({fmt::format("time_excess.{}_{}", group.first, group.second),
                       excess,
                       "",
                       comparable.size(),
                       {}});
    if (!worst || excess > worst->value) {
      worst = Figure{"time_excess_small", excess, "", comparable.size(), {}};
    }
  }
  if (worst) {
    figures.push_back(*worst);
  }
}

void add_group(const std::string& name,
               const std::vector<TeamPair>& pairs,
               std::vector<Figure>& figures) {
  const auto count = [&](const auto& holds) {
    figures.back().value = static_cast<double>(std::ranges::count_if(pairs, holds));
  };
  figures.push_back({"joined." + name, 0.0, "", pairs.size(), {}});
  count([](const TeamPair& pair) { return pair.team.is_joined(); });
  figures.push_back({"complete." + name, 0.0, "", pairs.size(), {}});
  count([](const TeamPair& pair) { return pair.team.is_complete(); });
  figures.push_back({"floor_90." + name, 0.0, "", pairs.size(), {}});
  count([](const TeamPair& pair) { return pair.team.floor_90_s.has_value(); });
  figures.push_back({"floor_90_alone." + name, 0.0, "", pairs.size(), {}});
  count([](const TeamPair& pair) { return pair.alone.floor_90_s.has_value(); });
  const auto median_of = [&](const char* what, const char* unit, const Pick& pick) {
    add_median(std::string(what) + "." + name, picked(pairs, pick), unit, figures);
  };
  median_of("joined_s", "s", [](const TeamPair& pair) { return pair.team.joined_s; });
  median_of("time_ratio", "", [](const TeamPair& pair) { return pair.time_ratio(); });
  median_of("ideal_ratio", "", [](const TeamPair& pair) { return pair.ideal_ratio; });
  median_of("beyond_own_m", "m", [](const TeamPair& pair) { return pair.team.beyond_own_m; });
  median_of("free_iou", "", [](const TeamPair& pair) { return pair.team.free_iou; });
  median_of("free_iou_alone", "", [](const TeamPair& pair) { return pair.alone.free_iou; });
  median_of(
      "solid_called_free", "", [](const TeamPair& pair) { return pair.team.solid_called_free; });
  median_of("solid_called_free_alone", "", [](const TeamPair& pair) {
    return pair.alone.solid_called_free;
  });
}

void add_sums(const std::vector<TeamPair>& pairs, std::vector<Figure>& figures) {
  const auto add = [&](const char* name, const char* unit, bool is_mean, const Pick& pick) {
    double sum = 0.0;
    const auto values = picked(pairs, pick);
    for (const double value : values) {
      sum += value;
    }
    if (!values.empty()) {
      const double count = static_cast<double>(values.size());
      figures.push_back({name, is_mean ? sum / count : sum, unit, values.size(), {}});
    }
  };
  constexpr bool kMean = true;
  constexpr bool kSum = false;
  add("kbytes_per_s_per_robot", "kB/s", kMean, [](const TeamPair& pair) {
    return pair.team.kbytes_per_s_per_robot;
  });
  const auto count = [](auto value) { return std::optional(static_cast<double>(value)); };
  add("deadlocks_seen", "", kSum, [&](const TeamPair& pair) { return count(pair.team.deadlocks); });
  add("deadlocks_left", "", kSum, [&](const TeamPair& pair) {
    return count(pair.team.deadlocks_left);
  });
  add("team_hard_collisions", "", kSum, [&](const TeamPair& pair) {
    return count(pair.team.hard_collisions);
  });
  add("team_cpu_s", "s", kMean, [&](const TeamPair& pair) { return count(pair.team.cpu_s); });
}

}  // namespace

MarkdownTable team_table(const std::vector<TeamPair>& pairs) {
  MarkdownTable table;
  table.header = {"world",      "robots",          "seed",          "exit",
                  "outcome",    "joined s",        "pose m",        "beyond m",
                  "deg",        "wrong seen/left", "free_iou",      "solid free",
                  "floor",      "90 % at s",       "ratio (ideal)", "sim s",
                  "bumps/hard", "locks seen/left", "kB/s",          "wall s",
                  "cpu s",      "each robot"};
  for (const TeamPair& pair : pairs) {
    table.rows.push_back(row_of(pair.team, ratio_of(pair)));
    table.rows.push_back(row_of(pair.alone, ""));
  }
  return table;
}

std::vector<Figure> team_figures(const std::vector<TeamPair>& pairs) {
  std::vector<Figure> figures;
  if (pairs.empty()) {
    return figures;
  }
  add_merging(pairs, figures);
  const Groups groups = grouped(pairs);
  for (const auto& [group, of_group] : groups) {
    if (group.first == kLarge) {
      add_median(fmt::format("time_ratio_{}_large", group.second),
                 picked(of_group, [](const TeamPair& pair) { return pair.time_ratio(); }),
                 "",
                 figures);
    }
  }
  add_excess(groups, figures);
  add_sums(pairs, figures);
  for (const auto& [group, of_group] : groups) {
    add_group(fmt::format("{}_{}", group.first, group.second), of_group, figures);
  }
  return figures;
}

}  // namespace echomap::bench
