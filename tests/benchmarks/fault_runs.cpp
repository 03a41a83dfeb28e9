// SPDX-License-Identifier: MIT
#include "tests/benchmarks/fault_runs.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <random>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/session/child_process.hpp"

namespace echomap::bench {
namespace {

constexpr std::chrono::minutes kPatienceWithFaults(10);
/// The self-check is over after so many stops.
constexpr int kCheckedStops = 8;
constexpr const char* kRoughBody = "uno_2wd_rough";

bool is_named_right(const FaultFinding& finding) {
  return finding.has_run && finding.name == finding.robot.fault.name;
}

double percent_of(std::size_t part, std::size_t all) {
  return all == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(all);
}

/// How many of the findings are so, and of how many.
struct Count {
  std::size_t right = 0;
  std::size_t wrong = 0;  ///< Named another one.
  std::size_t early = 0;  ///< Right, and within three stops.
  std::size_t all = 0;

  void add(const FaultFinding& finding) {
    constexpr std::size_t kEarlyStops = 3;
    ++all;
    right += is_named_right(finding) ? 1 : 0;
    wrong += !finding.name.empty() && !is_named_right(finding) ? 1 : 0;
    early += is_named_right(finding) && finding.stops <= kEarlyStops ? 1 : 0;
  }
};

}  // namespace

const std::vector<BuiltFault>& built_faults() {
  static const std::vector<BuiltFault> all{
      {"motors-swapped@0", "both-wheels-against-command"},
      {"motor-left-reversed@0", "left-wheel-against-command"},
      {"motor-right-reversed@0", "right-wheel-against-command"},
      {"encoder-left-reversed@0", "left-wheel-against-command"},
      {"encoder-right-reversed@0", "right-wheel-against-command"},
      {"motor-left-reversed@0,encoder-left-reversed@0", "left-wheel-reversed"},
      {"motor-right-reversed@0,encoder-right-reversed@0", "right-wheel-reversed"},
      {"encoder-left@0", "left-wheel-stands"},
      {"encoder-right@0", "right-wheel-stands"},
      {"counts@0:inf:0.5", "counts"},
      {"counts@0:inf:2", "counts"},
      {"wheel-left@0:inf:1.08", "left-wheel-size"},
      {"wheel-left@0:inf:0.92", "left-wheel-size"},
      {"wheel-right@0:inf:1.08", "right-wheel-size"},
      {"wheel-right@0:inf:0.92", "right-wheel-size"},
      {"wheel-left@0:inf:1.08,wheel-right@0:inf:1.08", "wheel-size"},
      {"wheel-left@0:inf:0.92,wheel-right@0:inf:0.92", "wheel-size"},
      {"pan-reversed@0", "pan-reversed"},
      {"pan-off@0:inf:7", "pan-offset"},
      {"pan-off@0:inf:-7", "pan-offset"},
      {"range-scale@0:inf:1.1", "range-scale"},
      {"range-scale@0:inf:0.9", "range-scale"}};
  return all;
}

std::vector<DrawnRobot> draw_robots(const std::vector<std::string>& worlds,
                                    std::size_t count,
                                    int first_seed) {
  std::mt19937 random(static_cast<std::uint32_t>(first_seed));
  const auto draw = [&](std::size_t size) {
    return std::uniform_int_distribution<std::size_t>(0, size - 1)(random);
  };
  std::vector<DrawnRobot> robots;
  for (std::size_t i = 0; i < count; ++i) {
    const int seed = first_seed + static_cast<int>(i);
    robots.push_back({built_faults()[draw(built_faults().size())],
                      worlds[draw(worlds.size())],
                      "uno_2wd",
                      seed});
    robots.push_back({{}, worlds[draw(worlds.size())], i % 2 == 0 ? "uno_2wd" : kRoughBody, seed});
  }
  return robots;
}

FaultFinding find_fault(const DrawnRobot& robot, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::vector<std::string> command{session::program_folder() / "echomap",
                                   "demo",
                                   "--headless",
                                   "--no-kidnap",
                                   "--emulator=mock",
                                   "--world=" + robot.world,
                                   "--body=" + robot.body,
                                   "--seed=" + std::to_string(robot.seed),
                                   "--stops=" + std::to_string(kCheckedStops),
                                   "--out=" + (folder / "run").string(),
                                   "--force"};
  if (!robot.fault.part_faults.empty()) {
    command.push_back("--part-faults=" + robot.fault.part_faults);
  }
  FaultFinding finding{robot, false, "", 0};
  try {
    session::ChildProcess program(command, folder / "demo.log");
    program.wait_for(kPatienceWithFaults);
    const auto summary = nlohmann::json::parse(files::read_text_file(folder / "run/summary.json"));
    finding.has_run = true;
    if (const auto& fault = summary.at("robot_fault"); !fault.is_null()) {
      finding.name = fault.at("name").get<std::string>();
      finding.stops = fault.at("stops").get<std::size_t>();
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}, seed {}: {}\n", robot.world, robot.seed, error.what());
  }
  fmt::print(stderr,
             "{:14} seed {:4} {:13} {:48} {}{}\n",
             robot.world,
             robot.seed,
             robot.body,
             robot.fault.part_faults.empty() ? "sound" : robot.fault.part_faults,
             is_named_right(finding) ? "right"
             : finding.name.empty()  ? "not named"
                                     : "WRONG: ",
             is_named_right(finding) ? "" : finding.name);
  return finding;
}

std::vector<Figure> fault_figures(const std::vector<FaultFinding>& findings) {
  Count faulty;
  Count fine;
  Count rough;
  for (const FaultFinding& finding : findings) {
    const bool is_sound = finding.robot.fault.name.empty();
    (!is_sound ? faulty : finding.robot.body == kRoughBody ? rough : fine).add(finding);
  }
  return {
      {"faults_named_percent", percent_of(faulty.right, faulty.all), "%", faulty.all, {}},
      {"faults_named_wrongly_percent", percent_of(faulty.wrong, faulty.all), "%", faulty.all, {}},
      {"faults_named_in_3_stops_percent",
       percent_of(faulty.early, faulty.all),
       "%",
       faulty.all,
       {}},
      {"healthy_accused_of_200",
       static_cast<double>(fine.wrong + rough.wrong),
       "",
       fine.all + rough.all,
       {}},
      {"healthy_accused_rough", static_cast<double>(rough.wrong), "", rough.all, {}}};
}

MarkdownTable fault_table(const std::vector<FaultFinding>& findings) {
  std::map<std::string, Count> counts;
  for (const FaultFinding& finding : findings) {
    const std::string& name = finding.robot.fault.name;
    counts[!name.empty() ? name : "none, " + finding.robot.body].add(finding);
  }
  MarkdownTable table{{"fault", "robots", "named right", "in 3 stops", "another named"}, {}};
  for (const auto& [name, count] : counts) {
    table.rows.push_back({name,
                          std::to_string(count.all),
                          std::to_string(count.right),
                          std::to_string(count.early),
                          std::to_string(count.wrong)});
  }
  return table;
}

}  // namespace echomap::bench
