// SPDX-License-Identifier: MIT
/// Searches a source offline, in an open hall and in rooms with shielding walls: alone, three
/// robots that share their readings, and the first of three that do not; and three that share under
/// other backgrounds, of which they know as little.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "host/models/uniform_sample.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/support/offline_source_search.hpp"

namespace {

using namespace echomap;

constexpr std::size_t kTeam = 3;
constexpr double kStartsApartM = 2.0;
constexpr double kBackground = 0.4;
constexpr double kOtherBackgrounds[] = {0.1, 1.5};
/// Draws of a bootstrap, and the share of them that is left out on each side.
constexpr std::size_t kDraws = 1000;
constexpr double kTail = 0.025;

/// The task of a seed, as it is for each team.
struct Task {
  tests::SourceTruth truth;
  std::vector<geometry::Pose2> starts;
};

/// Every fourth floor has no source. Strengths of 1 to 20 pulses/s, evenly by logarithm.
Task task_of(const tests::SourceWorld& world, std::uint32_t seed) {
  std::mt19937 random(seed * 7919U);
  Task task;
  task.truth.background = kBackground;
  task.truth.attenuation_per_m = 2.0 + 18.0 * models::uniform_sample(random);
  const Eigen::Vector2d at_m = world.sample_free(0.05, random);
  task.truth.strength = std::pow(20.0, models::uniform_sample(random));
  if (seed % 4 != 0) {
    task.truth.at_m = at_m;
  }
  task.starts = tests::sample_starts(world, kTeam, kStartsApartM, random);
  return task;
}

/// How one robot or team has ended.
struct Ending {
  std::string team;
  double background = kBackground;
  tests::OfflineSearchRun run;

  bool is_found() const { return run.estimate.verdict == source_search::SourceVerdict::kFound; }
};

/// All that was done with the task of a seed.
struct Trial {
  std::string world;
  std::uint32_t seed = 0;
  bool has_source = false;
  std::vector<Ending> endings;

  /// Of the first of that team that was sure, under the usual background.
  double first_s(const std::string& team) const {
    double first_s = std::numeric_limits<double>::infinity();
    for (const Ending& ending : endings) {
      if (ending.team.starts_with(team) && ending.background == kBackground) {
        first_s = std::min(first_s, ending.run.time_s);
      }
    }
    return first_s;
  }
};
using Trials = std::vector<const Trial*>;

tests::OfflineSearchRun run_of(const tests::SourceWorld& world,
                               const Task& task,
                               std::vector<geometry::Pose2> starts,
                               std::uint32_t seed) {
  tests::OfflineSearch search;
  search.params.explores = false;
  search.params.frontier.navigator.follower.speed_m_per_s = search.params.choice.speed_m_per_s;
  search.starts = std::move(starts);
  search.seed = seed;
  return tests::search_offline(world, task.truth, search);
}

Trial trial_of(const tests::SourceWorld& world, const std::string& name, std::uint32_t seed) {
  Task task = task_of(world, seed);
  Trial trial{name, seed, task.truth.at_m.has_value(), {}};
  trial.endings.push_back({"sharing", kBackground, run_of(world, task, task.starts, 10 * seed)});
  for (std::uint32_t robot = 0; robot < kTeam; ++robot) {
    trial.endings.push_back({fmt::format("alone{}", robot),
                             kBackground,
                             run_of(world, task, {task.starts[robot]}, 10 * seed + 1 + robot)});
  }
  for (const double background : kOtherBackgrounds) {
    task.truth.background = background;
    trial.endings.push_back({"sharing", background, run_of(world, task, task.starts, 10 * seed)});
  }
  return trial;
}

double sum_s(const Trials& trials, const std::string& team, bool has_source) {
  double sum = 0.0;
  for (const Trial* trial : trials) {
    sum += trial->has_source == has_source ? trial->first_s(team) : 0.0;
  }
  return sum;
}

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? std::nan("") : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

/// Of the endings that count: those of which `is_right`.
double right_percent(const Trials& trials,
                     const std::function<bool(const Trial&, const Ending&)>& counts) {
  std::size_t all = 0;
  std::size_t right = 0;
  for (const Trial* trial : trials) {
    for (const Ending& ending : trial->endings) {
      all += counts(*trial, ending) ? 1U : 0U;
      right += counts(*trial, ending) && ending.run.is_right ? 1U : 0U;
    }
  }
  return percent(right, all);
}

/// A number that is made of trials.
struct Statistic {
  std::string name;
  std::string unit;
  std::function<double(const Trials&)> of;
};

std::vector<Statistic> statistics() {
  const auto with_background = [](bool is_usual) {
    return [is_usual](const Trial& /*trial*/, const Ending& ending) {
      return ending.is_found() && (ending.background == kBackground) == is_usual;
    };
  };
  const auto mean_s = [](const std::string& team, bool has_source) {
    return [team, has_source](const Trials& trials) {
      const auto tasks = std::count_if(trials.begin(), trials.end(), [&](const Trial* trial) {
        return trial->has_source == has_source;
      });
      return sum_s(trials, team, has_source) / static_cast<double>(tasks);
    };
  };
  return {
      {"source_alone_s", "s", mean_s("alone0", true)},
      {"source_sharing_s", "s", mean_s("sharing", true)},
      {"source_first_of_three_s", "s", mean_s("alone", true)},
      {"none_alone_s", "s", mean_s("alone0", false)},
      {"none_sharing_s", "s", mean_s("sharing", false)},
      {"source_time_ratio",
       "",
       [](const Trials& trials) {
         return sum_s(trials, "sharing", true) / sum_s(trials, "alone0", true);
       }},
      {"sharing_saving_percent",
       "%",
       [](const Trials& trials) {
         return 100.0 * (1.0 - sum_s(trials, "sharing", true) / sum_s(trials, "alone", true));
       }},
      {"none_right_percent",
       "%",
       [](const Trials& trials) {
         return right_percent(
             trials, [](const Trial& trial, const Ending& /*any*/) { return !trial.has_source; });
       }},
      {"claims_right_percent",
       "%",
       [](const Trials& trials) {
         return right_percent(
             trials, [](const Trial& /*any*/, const Ending& ending) { return ending.is_found(); });
       }},
      {"claims_right_usual_background_percent",
       "%",
       [=](const Trials& trials) { return right_percent(trials, with_background(true)); }},
      {"claims_right_other_background_percent",
       "%",
       [=](const Trials& trials) { return right_percent(trials, with_background(false)); }},
      {"claims_stated_percent",
       "%",
       [](const Trials& trials) {
         double sum = 0.0;
         std::size_t claims = 0;
         for (const Trial* trial : trials) {
           for (const Ending& ending : trial->endings) {
             sum += ending.is_found() ? ending.run.estimate.within_probability : 0.0;
             claims += ending.is_found() ? 1U : 0U;
           }
         }
         return 100.0 * sum / static_cast<double>(claims);
       }},
  };
}

/// Efron's percentile bootstrap over tasks.
std::string interval_of(const Statistic& statistic, const Trials& trials) {
  std::mt19937 random(1);
  std::vector<double> values;
  for (std::size_t draw = 0; draw < kDraws; ++draw) {
    Trials drawn;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      drawn.push_back(trials[random() % trials.size()]);
    }
    const double value = statistic.of(drawn);
    if (std::isfinite(value)) {
      values.push_back(value);
    }
  }
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return fmt::format("{:.3g} to {:.3g}", at(kTail), at(1.0 - kTail));
}

void add_figures(const std::vector<Trial>& trials,
                 const std::string& world,
                 std::vector<bench::Figure>& figures,
                 bench::Notes& notes) {
  Trials of_world;
  for (const Trial& trial : trials) {
    if (world.empty() || trial.world == world) {
      of_world.push_back(&trial);
    }
  }
  for (const Statistic& statistic : statistics()) {
    const std::string name = statistic.name + (world.empty() ? "" : "." + world);
    figures.push_back({name, statistic.of(of_world), statistic.unit, of_world.size(), {}});
    notes[name] = interval_of(statistic, of_world);
  }
}

void write_trials(const std::vector<Trial>& trials, const std::filesystem::path& path) {
  std::ofstream csv(path);
  csv << "world,seed,has_source,team,background,time_s,verdict,stated,error_m,right\n";
  for (const Trial& trial : trials) {
    for (const Ending& ending : trial.endings) {
      csv << fmt::format("{},{},{},{},{},{:.2f},{},{:.4f},{:.3f},{}\n",
                         trial.world,
                         trial.seed,
                         trial.has_source ? 1 : 0,
                         ending.team,
                         ending.background,
                         ending.run.time_s,
                         source_search::name_of(ending.run.estimate.verdict),
                         ending.run.estimate.within_probability,
                         ending.run.error_m,
                         ending.run.is_right ? 1 : 0);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Search a source offline, alone and as a team");
  std::uint32_t seeds = 40;
  std::uint32_t first_seed = 1;
  std::filesystem::path json;
  std::filesystem::path csv;
  app.add_option("--seeds", seeds, "Tasks per world, 4 at least")->check(CLI::Range(4, 10000));
  app.add_option("--first-seed", first_seed, "Of the first task")->check(CLI::PositiveNumber);
  app.add_option("--json", json, "Write the figures to this file");
  app.add_option("--csv", csv, "Write how each search ended to this file");
  CLI11_PARSE(app, argc, argv);
  const tests::SourceWorld hall = tests::open_hall();
  const tests::SourceWorld rooms = tests::shielding_rooms();
  std::vector<Trial> trials;
  for (std::uint32_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    trials.push_back(trial_of(hall, "hall", seed));
    trials.push_back(trial_of(rooms, "rooms", seed));
    std::cerr << "seed " << seed << '\n';
    if (!csv.empty()) {
      write_trials(trials, csv);
    }
  }
  std::vector<bench::Figure> figures;
  bench::Notes notes;
  for (const char* world : {"", "hall", "rooms"}) {
    add_figures(trials, world, figures, notes);
  }
  bench::report(figures, json, notes);
  return 0;
}
