// SPDX-License-Identifier: MIT
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/live_run.hpp"
#include "host/apps/report.hpp"
#include "host/apps/run_recording.hpp"
#include "host/apps/source_layer.hpp"
#include "host/apps/source_report.hpp"
#include "host/apps/source_setup.hpp"
#include "host/console/print.hpp"
#include "host/console/shell_line.hpp"
#include "host/files/bundled_files.hpp"
#include "host/session/profile_driver.hpp"
#include "host/session/simulated_robots.hpp"
#include "host/source_search/source_explorer.hpp"

namespace echomap::apps {
namespace {

/// Times real time, for a simulated robot on a live page.
constexpr double kShownSpeed = 8.0;

using session::RobotContext;
using session::RobotProfile;
using source_search::SourceExplorer;
using source_search::SourceReadings;
using source_search::SourceSearch;

/// The simulated robot that is asked for; empty where the robot is at a port.
std::optional<session::SimulatedRobots> simulate(const SearchOptions& options,
                                                 const RobotProfile& profile,
                                                 const std::filesystem::path& out) {
  if (options.robot.world.empty()) {
    return std::nullopt;
  }
  session::SimulatedRobotOptions robot = options.robot;
  robot.driver = session::driver_of(profile.toml);
  return std::optional<session::SimulatedRobots>(
      std::in_place,
      robot,
      session::Seed(options.run.seed),
      files::bundled_file(profile.name, "hil_mock/robots", "body"),
      out);
}

NextCommands next_of_search(const SearchOptions& options, const std::filesystem::path& out) {
  console::CommandWords again{"echomap", "search", "--robot", options.run.robot};
  const auto say = [&again](const char* option, const std::string& value) {
    again.insert(again.end(), {option, value});
  };
  if (!options.robot.world.empty()) {
    say("--world", options.robot.world);
    say("--emulator", options.robot.emulator);
    for (const std::string& source : options.robot.sources) {
      say("--source", source);
    }
  }
  for (const std::string& port : options.connection.ports) {
    say("--port", port);
  }
  const std::string search = console::shell_line(again);
  const std::string find = console::shell_line({"echomap", "localize", "--map", out.string()});
  return {console::shell_line({"echomap", "serve", out.string()}), search, find, search};
}

/// Ends the robot, and writes what was found beside the map and into the summary; answers how the
/// search has ended.
RunEnding report_on_search(RobotContext& robot,
                           const RunEnding& drive,
                           const SourceSearch* search,
                           const ExploreRun& run,
                           const std::filesystem::path& json,
                           exports::RunSummary& summary) {
  const auto* belief = search != nullptr ? search->belief() : nullptr;
  nlohmann::ordered_json source = source_report(belief);
  if (robot.quit()) {
    add_source_truth(run.out / "truth" / "source.json", source);
  }
  RunEnding ending = ending_of_search(drive, source, run.next);
  describe_ending(ending, summary);
  summary.strategy = "source";
  auto report = nlohmann::ordered_json::parse(exports::to_json_text(summary));
  report["source"] = source;
  write_report(run.out / "source.json", source);
  if (belief != nullptr) {
    write_source_density(run.out / "source_density.csv", *belief);
  }
  write_report(run.out / "summary.json", report);
  end_recording(robot, report, run.out);
  write_report(json, report);
  console::print("map: " + (run.out / "map.png").string());
  if (source.contains("truth")) {
    console::print("source: " + source.at("verdict").get<std::string>() +
                   ", truth: " + source.at("truth").dump());
  }
  return ending;
}

}  // namespace

ExitCode run_search(const SearchOptions& options) {
  const RunOptions& run = options.run;
  RobotProfile profile = profile_for(run.robot, run.strategy);
  validate_searcher(profile);
  const auto out = run_folder(run.out);
  prepare_outputs(out, run.json, run.force);
  std::optional<session::SimulatedRobots> simulated = simulate(options, profile, out);
  SourceReadings readings(source_readings_params(profile));
  RobotContext robot(std::move(profile), session::Seed(run.seed));
  robot.fork().add(readings);
  LiveRun live(options.live,
               robot,
               {.command = "search", .out = out, .is_simulated = simulated.has_value()});
  begin_maps(robot, "", run.slam);
  exports::RunSummary summary;
  summary.world = options.robot.world;
  open_port(robot, simulated ? simulated->connection() : options.connection, run.strategy, summary);
  if (simulated && live.serves()) {
    robot.time_scale().set_factor(kShownSpeed);
  }

  const double max_s = options.max_s.value_or(std::numeric_limits<double>::infinity());
  std::shared_ptr<SourceSearch> search;
  ExploreRun explore{run.strategy, live, out, progress_display(run), run.align, split_bytes(run)};
  explore.next = next_of_search(options, out);
  SourceLayer layer;
  explore.show_more = [&](double time_s, live_page::RunPublisher& publisher) {
    layer.publish(time_s, search ? search->belief() : nullptr, publisher);
  };
  explore.make_explorer = [&](const strategies::StrategyOptions& /*left*/) {
    search = std::make_shared<SourceSearch>(source_search_params(robot.profile()));
    return strategies::under_watch(
        std::make_unique<SourceExplorer>(search, readings, max_s), robot.profile(), true);
  };
  const RunEnding drive = explore_and_save(robot, explore, summary);
  const RunEnding ending = report_on_search(robot, drive, search.get(), explore, run.json, summary);
  print_ending(ending);
  live.end(ending);
  return ending.code;
}

}  // namespace echomap::apps
