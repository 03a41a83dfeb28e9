// SPDX-License-Identifier: MIT
/// Searches a source offline, in an open hall and in rooms with shielding walls: alone, three
/// robots that share their readings, and the first of three that do not.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "host/models/uniform_sample.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/support/offline_source_search.hpp"

namespace {

using namespace echomap;

/// The task of a seed, as it is for each team.
struct Task {
  tests::SourceTruth truth;
  std::vector<geometry::Pose2> starts;
};

constexpr std::size_t kTeam = 3;
constexpr double kStartsApartM = 2.0;

/// Every fourth floor has no source. Strengths of 1 to 20 pulses/s, evenly by logarithm.
Task task_of(const tests::SourceWorld& world, std::uint32_t seed, double background) {
  std::mt19937 random(seed * 7919U);
  Task task;
  task.truth.background = background;
  task.truth.attenuation_per_m = 2.0 + 18.0 * models::uniform_sample(random);
  const Eigen::Vector2d at_m = world.sample_free(0.05, random);
  task.truth.strength = std::pow(20.0, models::uniform_sample(random));
  if (seed % 4 != 0) {
    task.truth.at_m = at_m;
  }
  task.starts = tests::sample_starts(world, kTeam, kStartsApartM, random);
  return task;
}

/// What a kind of team has done in all tasks.
struct Sums {
  double found_s = 0.0;  ///< Where there is a source.
  double none_s = 0.0;
  std::size_t found_tasks = 0;
  std::size_t none_tasks = 0;
  std::size_t none_right = 0;
  std::size_t claims = 0;  ///< Of a place.
  std::size_t right = 0;

  void add(const Task& task, const tests::OfflineSearchRun& run) {
    (task.truth.at_m ? found_s : none_s) += run.time_s;
    (task.truth.at_m ? found_tasks : none_tasks) += 1;
    none_right += !task.truth.at_m && run.is_right ? 1U : 0U;
    if (run.estimate.verdict == source_search::SourceVerdict::kFound) {
      claims += 1;
      right += run.is_right ? 1U : 0U;
    }
  }
};

struct Comparison {
  Sums alone;
  Sums sharing;
  Sums first_of_three;
};

tests::OfflineSearchRun run_of(const tests::SourceWorld& world,
                               const Task& task,
                               std::vector<geometry::Pose2> starts,
                               std::uint32_t seed) {
  tests::OfflineSearch search;
  search.params.explores = false;
  search.params.navigator.follower.speed_m_per_s = search.params.choice.speed_m_per_s;
  search.starts = std::move(starts);
  search.seed = seed;
  return tests::search_offline(world, task.truth, search);
}

Comparison compare(const tests::SourceWorld& world, std::uint32_t seeds, double background) {
  Comparison comparison;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    const Task task = task_of(world, seed, background);
    comparison.sharing.add(task, run_of(world, task, task.starts, 10 * seed));
    auto first = run_of(world, task, {task.starts[0]}, 10 * seed + 1);
    comparison.alone.add(task, first);
    for (std::uint32_t robot = 1; robot < kTeam; ++robot) {
      const auto other = run_of(world, task, {task.starts[robot]}, 10 * seed + 1 + robot);
      first = other.time_s < first.time_s ? other : first;
    }
    comparison.first_of_three.add(task, first);
    std::cerr << world.size_m().x() << " m: seed " << seed << " of " << seeds << '\n';
  }
  return comparison;
}

void add_figures(std::vector<bench::Figure>& figures,
                 const std::string& world,
                 const Comparison& comparison) {
  const Sums& alone = comparison.alone;
  const Sums& sharing = comparison.sharing;
  const Sums& first = comparison.first_of_three;
  const std::size_t found = alone.found_tasks;
  const auto mean_s = [&](const Sums& sums) { return sums.found_s / static_cast<double>(found); };
  figures.push_back({"source_alone_s." + world, mean_s(alone), "s", found, {}});
  figures.push_back({"source_sharing_s." + world, mean_s(sharing), "s", found, {}});
  figures.push_back({"source_first_of_three_s." + world, mean_s(first), "s", found, {}});
  figures.push_back({"source_time_ratio." + world, sharing.found_s / alone.found_s, "", found, {}});
  figures.push_back({"sharing_saving_percent." + world,
                     100.0 * (1.0 - sharing.found_s / first.found_s),
                     "%",
                     found,
                     {}});
  const std::size_t none = alone.none_tasks + sharing.none_tasks + first.none_tasks;
  const std::size_t none_right = alone.none_right + sharing.none_right + first.none_right;
  figures.push_back({"none_right_percent." + world,
                     100.0 * static_cast<double>(none_right) / static_cast<double>(none),
                     "%",
                     none,
                     {}});
  const std::size_t claims = alone.claims + sharing.claims + first.claims;
  const std::size_t right = alone.right + sharing.right + first.right;
  figures.push_back({"claims_right_percent." + world,
                     100.0 * static_cast<double>(right) / static_cast<double>(claims),
                     "%",
                     claims,
                     {}});
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Search a source offline, alone and as a team");
  std::uint32_t seeds = 40;
  double background = 0.4;
  std::filesystem::path json;
  app.add_option("--seeds", seeds, "Tasks per world, 4 at least")->check(CLI::Range(4, 10000));
  app.add_option("--background", background, "Pulses/s")->check(CLI::PositiveNumber);
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  std::vector<bench::Figure> figures;
  add_figures(figures, "hall", compare(tests::open_hall(), seeds, background));
  add_figures(figures, "rooms", compare(tests::shielding_rooms(), seeds, background));
  bench::report(figures, json);
  return 0;
}
