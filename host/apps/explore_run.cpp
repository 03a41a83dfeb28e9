// SPDX-License-Identifier: MIT
#include "host/apps/explore_run.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <variant>

#include <spdlog/spdlog.h>

#include "host/apps/explore_progress.hpp"
#include "host/apps/report.hpp"
#include "host/apps/run_keeper.hpp"
#include "host/console/print.hpp"
#include "host/exploration/atlas_explorer.hpp"
#include "host/exports/run_directory.hpp"
#include "host/strategies/strategy_setup.hpp"

namespace echomap::apps {
namespace {

using exploration::MotionResult;

/// Of all maps.
std::size_t stops_in(const pipeline::RobotAtlas& atlas) {
  std::size_t stops = atlas.pipeline().snapshot().stops;
  for (const pipeline::FormerMap& former : atlas.former_maps()) {
    stops += former.pipeline.snapshot().stops;
  }
  return stops;
}

/// How many stops the robot has made, and how many it had when this run began.
struct StopCount {
  std::size_t made = 0;
  std::size_t before = 0;
};

/// Of the whole map, as the summary is.
std::string progress_line(const DrivenRobot& robot,
                          const RunOptions& options,
                          const StopCount& stops) {
  exports::RunSummary summary;
  exports::describe_snapshot(robot.atlas.pipeline().snapshot(), summary);
  ExploreProgress progress;
  progress.stops = summary.stops;
  progress.stops_elsewhere = stops.made - std::min(stops.made, summary.stops);
  progress.floor_m2 = summary.free_area_m2;
  progress.travelled_m = summary.travelled_m;
  progress.elapsed_s = elapsed_s(robot);
  switch (strategies::limit_of(options.strategy)) {
    case strategies::StrategyLimit::kStops:
      progress.most_stops = stops.before + options.strategy.stops * options.strategy.scans;
      break;
    case strategies::StrategyLimit::kSeconds:
      progress.most_s = before_this_run(robot).sim_seconds + options.strategy.seconds;
      break;
    case strategies::StrategyLimit::kNone:
      break;
  }
  return line_of(progress);
}

/// Told of what becomes of a robot that is lost.
class MapsTeller {
 public:
  explicit MapsTeller(const pipeline::RobotAtlas& atlas)
      : atlas_(atlas), joins_(atlas.joins()), changes_(atlas.changes()) {}

  void tell() {
    if (std::exchange(joins_, atlas_.joins()) != atlas_.joins()) {
      console::print("it has found itself in the map of before: both are one");
    } else if (changes_ != atlas_.changes()) {
      console::print(
          "what the sonar hears is not what the map has there, or the robot was lifted: the map so "
          "far is set aside, and another one begun");
    }
    changes_ = atlas_.changes();
  }

 private:
  const pipeline::RobotAtlas& atlas_;
  std::size_t joins_;
  std::size_t changes_;
};

/// Where the robot may be in another map, as that of a strategy which goes anywhere, under the eyes
/// of one that sets maps aside.
std::unique_ptr<exploration::AtlasExplorer> explorer_of(const DrivenRobot& robot,
                                                        const RunOptions& options,
                                                        std::mt19937& random) {
  const auto make = [&](std::size_t stops_made) -> std::unique_ptr<exploration::Explorer> {
    strategies::StrategyOptions left = options.strategy;
    left.stops -= std::min(left.stops, stops_made / left.scans);
    return left.stops > 0 ? strategies::explorer_for(robot.profile, left, random) : nullptr;
  };
  return std::make_unique<exploration::AtlasExplorer>(
      make,
      robot.atlas.pipeline().snapshot().stops,
      robot.camera == nullptr && strategies::begins_anywhere(options.strategy));
}

/// Motion by motion until the explorer has finished or the session has ended.
std::optional<exploration::FinishReason> drive(const DrivenRobot& robot,
                                               exploration::Explorer& explorer,
                                               RunKeeper& keeper) {
  MotionResult last = MotionResult::kReached;
  MapsTeller maps(robot.atlas);
  while (!robot.session.end()) {
    const auto motion = explorer.next(robot.atlas.pipeline().snapshot(), last);
    maps.tell();
    if (const auto* finished = std::get_if<exploration::Finished>(&motion)) {
      return finished->reason;
    }
    last = robot.session.execute(motion);
    if (std::holds_alternative<exploration::EndScan>(motion)) {
      keeper.save_in_passing();
    }
  }
  return std::nullopt;
}

/// For people: why an exploration that has ended early did so, and what to do; empty for the
/// others.
std::string trouble_of(exploration::FinishReason reason) {
  switch (reason) {
    case exploration::FinishReason::kCannotSense:
      return "no sweep of the sonar was carried out\n  next: check the pan drive and the sonar's "
             "wires";
    case exploration::FinishReason::kStuck:
      return "the robot is stuck: held by something, or its wheels slip\n  next: free it, and "
             "start "
             "anew";
    case exploration::FinishReason::kLifted:
      return "the robot was picked up, and does not know where it is\n  next: put it down, and "
             "start "
             "anew";
    case exploration::FinishReason::kBatteryLow:
      return "the battery is low\n  next: charge it where it stands, and go on "
             "with echomap explore --resume";
    case exploration::FinishReason::kSonarSilent:
      return "nothing has answered the sonar all round\n  next: check the sonar's wires, or start "
             "where a wall is within its range";
    case exploration::FinishReason::kSonarStuck:
      return "the sonar says one range wherever it looks\n  next: check its wires and what stands "
             "right before it";
    case exploration::FinishReason::kWheelFault:
      return "a wheel does not turn, or its encoder does not count\n  next: free the wheels, and "
             "compare motors and encoders with docs/guides/wiring.md";
    case exploration::FinishReason::kLost:
      return "what the sonar hears is not what the map has there: carried off, or the wheels have "
             "slipped\n  next: find it again with echomap localize, or start anew";
    default:
      return "";
  }
}

ExitCode exit_code_of(exploration::FinishReason reason) {
  const std::string trouble = trouble_of(reason);
  if (trouble.empty()) {
    return ExitCode::kOk;
  }
  spdlog::error("the map so far is kept: {}", trouble);
  switch (reason) {
    case exploration::FinishReason::kStuck:
    case exploration::FinishReason::kLifted:
    case exploration::FinishReason::kBatteryLow:
    case exploration::FinishReason::kWheelFault:
      return ExitCode::kSafetyStop;
    default:
      return ExitCode::kRuntimeError;
  }
}

void describe_run(const DrivenRobot& robot,
                  const RunOptions& options,
                  exports::RunSummary& summary) {
  summary.echomap_version = ECHOMAP_VERSION;
  summary.robot = robot.profile.name;
  summary.slam = robot.atlas.pipeline().slam() != nullptr ? options.slam : session::kNoSlam;
  summary.strategy = options.strategy.name;
  summary.seed = options.seed;
  if (robot.resumed) {
    summary.resumed_stops = robot.resumed->stops;
  }
}

void warn_of_former_maps(const pipeline::RobotAtlas& atlas) {
  if (const std::size_t former = atlas.former_maps().size(); former > 0) {
    spdlog::warn(
        "the map is that since the robot was carried off or its wheels slipped; where {} lies on "
        "it "
        "was not found: kept in {}",
        former == 1 ? "the one before" : "those before",
        former == 1 ? "former_1" : "former_1, former_2, ...");
  }
}

/// Of a session that has ended before its strategy had.
ExitCode save_what_is_left(session::RobotSession& session, RunKeeper& keeper) {
  spdlog::error("the map so far is kept, for {}", session.end_reason());
  const session::SessionEnd end = session.end().value_or(session::SessionEnd::kLinkLost);
  keeper.save(outcome_of(end));
  return exit_code_of(end);
}

}  // namespace

session::RobotProfile profile_for(const RunOptions& options) {
  session::RobotProfile profile = session::load_robot_profile(options.robot);
  strategies::require_fit(profile, options.strategy);
  return profile;
}

ExitCode explore_and_save(const DrivenRobot& robot,
                          const RunOptions& options,
                          const std::filesystem::path& out,
                          exports::RunSummary& summary) {
  session::RobotSession& session = robot.session;
  tracking::CameraFollower* const camera = robot.camera;
  describe_run(robot, options, summary);
  std::mt19937 random(options.seed);
  const auto explorer = explorer_of(robot, options, random);
  RunKeeper keeper(robot, *explorer, out, summary);
  ProgressTeller progress(stderr, !options.headless);
  const std::size_t stops_before = stops_in(robot.atlas);
  const auto line = [&] {
    return progress_line(robot, options, {stops_before + explorer->stops_made(), stops_before});
  };
  session.on_step = [&, steps = 0]() mutable {
    constexpr int kStepsPerDrawing = 64;
    if (camera != nullptr) {
      camera->poll(session);
    }
    if (++steps % kStepsPerDrawing == 0) {
      progress.tell(elapsed_s(robot), line);
    }
  };

  session.connect();
  session.look_around_on_the_way(robot.atlas.pipeline().slam() != nullptr);
  if (camera != nullptr) {
    camera->begin(session);
  }
  const auto reason = drive(robot, *explorer, keeper);
  session.end_scan();
  session.look_around_on_the_way(false);
  session.disarm();
  session.on_step = nullptr;
  progress.clear();
  warn_of_former_maps(robot.atlas);
  if (reason) {
    keeper.save(exploration::name_of(*reason));
    return exit_code_of(*reason);
  }
  return save_what_is_left(session, keeper);
}

}  // namespace echomap::apps
