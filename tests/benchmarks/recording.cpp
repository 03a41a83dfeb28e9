// SPDX-License-Identifier: MIT
// What a recording costs, what is left of it where the program is killed, and whether a replay is
// what the run was, how much faster than the robot.
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/recording_cost.hpp"
#include "tests/benchmarks/replayed_runs.hpp"
#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

/// Where more of the session is lost, a recording does not count as readable.
constexpr double kMaxLostS = 10.0;

struct Options {
  std::string part = "all";
  std::uint32_t seeds = 20;
  std::string emulator = "simavr";
  int stops = 8;
  int kills = 20;
  int jobs = 2;
  std::filesystem::path json;

  bool has(const char* name) const { return part == "all" || part == name; }
};

/// Calls `work(i)` for each i below `count`, in so many threads.
template <class Work>
void in_threads(int jobs, std::size_t count, const Work& work) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads;
  threads.reserve(static_cast<std::size_t>(jobs));
  for (int job = 0; job < jobs; ++job) {
    threads.emplace_back([&] {
      for (std::size_t i = next++; i < count; i = next++) {
        work(i);
      }
    });
  }
}

void print_run(const LiveRun& run, const ReplayedRun& replayed) {
  fmt::print(stderr,
             "{} seed {} {}{}: {}, {:.0f} s of the robot in {:.2f} s, {:.1f} MB\n",
             run.room,
             run.seed,
             run.part_faults,
             run.kidnap.empty() ? "" : "kidnapped",
             replayed.differences.empty()
                 ? "the same"
                 : fmt::format("NOT THE SAME: {}", fmt::join(replayed.differences, ", ")),
             replayed.robot_s,
             replayed.replay_s,
             replayed.recording_mb);
}

/// One at a time: the time that a replay takes is a figure.
std::vector<Figure> replay_figures(const Options& options) {
  const auto runs = live_runs(options.seeds, options.emulator, options.stops);
  std::vector<double> factors;
  std::size_t identical = 0;
  for (const LiveRun& run : runs) {
    const ReplayedRun replayed = replay(run);
    print_run(run, replayed);
    identical += replayed.differences.empty() ? 1U : 0U;
    if (replayed.replay_s > 0.0) {
      factors.push_back(replayed.robot_s / replayed.replay_s);
    }
  }
  std::vector<Figure> figures{{fmt::format("replay_identical_of_{}", runs.size()),
                               static_cast<double>(identical),
                               "runs",
                               runs.size(),
                               {}}};
  if (!factors.empty()) {
    figures.push_back({"replay_realtime_factor", tests::median(factors), "x", factors.size(), {}});
    figures.push_back({"replay_realtime_factor_min",
                       *std::min_element(factors.begin(), factors.end()),
                       "x",
                       factors.size(),
                       {}});
  }
  return figures;
}

std::vector<Figure> kill_figures(const Options& options) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> after_s(6.0, 40.0);
  std::vector<double> kills_s(static_cast<std::size_t>(options.kills));
  std::generate(kills_s.begin(), kills_s.end(), [&] { return after_s(random); });
  std::vector<double> lost_s(kills_s.size());
  in_threads(2 * options.jobs, kills_s.size(), [&](std::size_t i) {
    lost_s[i] = seconds_lost_by_kill(kills_s[i], static_cast<std::uint32_t>(i + 1));
    fmt::print(stderr, "killed after {:.1f} s: {:.2f} s lost\n", kills_s[i], lost_s[i]);
  });
  const auto readable = std::count_if(
      lost_s.begin(), lost_s.end(), [](double s) { return s >= 0.0 && s <= kMaxLostS; });
  return {{fmt::format("kill9_readable_of_{}", lost_s.size()),
           static_cast<double>(readable),
           "files",
           lost_s.size(),
           {}},
          {"kill9_lost_max",
           lost_s.empty() ? 0.0 : *std::max_element(lost_s.begin(), lost_s.end()),
           "s",
           lost_s.size(),
           {}}};
}

std::vector<Figure> figures_of(const Options& options) {
  std::vector<Figure> figures;
  const auto append = [&](const std::vector<Figure>& more) {
    figures.insert(figures.end(), more.begin(), more.end());
  };
  if (options.has("cost")) {
    append(cost_figures());
  }
  if (options.has("kills")) {
    append(kill_figures(options));
  }
  if (options.has("replay")) {
    append(replay_figures(options));
  }
  return figures;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  echomap::bench::Options options;
  CLI::App app("What a recording costs, survives and replays to");
  app.add_option("--part", options.part, "Only these figures")
      ->check(CLI::IsMember({"all", "cost", "kills", "replay"}))
      ->capture_default_str();
  app.add_option("--seeds", options.seeds, "Replay so many seeds, each plain, reset and kidnapped")
      ->capture_default_str();
  app.add_option("--emulator", options.emulator, "Of the runs that are replayed")
      ->check(CLI::IsMember({"simavr", "mock"}))
      ->capture_default_str();
  app.add_option("--stops", options.stops, "Of each run; 0: as many as it takes")
      ->capture_default_str();
  app.add_option("--kills", options.kills, "Kill so many sessions")->capture_default_str();
  app.add_option("--jobs", options.jobs, "Twice as many sessions are killed at a time")
      ->capture_default_str();
  app.add_option("--json", options.json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  echomap::bench::report(echomap::bench::figures_of(options), options.json);
}
