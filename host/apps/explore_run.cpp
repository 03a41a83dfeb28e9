// SPDX-License-Identifier: MIT
#include "host/apps/explore_run.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <variant>

#include <spdlog/spdlog.h>

#include "host/apps/explore_view.hpp"
#include "host/apps/report.hpp"
#include "host/apps/run_writer.hpp"
#include "host/apps/session_progress.hpp"
#include "host/console/print.hpp"
#include "host/exploration/atlas_explorer.hpp"
#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "host/session/pipeline_setup.hpp"
#include "host/strategies/strategy_setup.hpp"
#include "host/tracking/camera_follower.hpp"

namespace echomap::apps {
namespace {

using exploration::FinishReason;
using exploration::MotionResult;
using session::RobotContext;
using session::RobotProfile;
using session::RobotSession;
using strategies::StrategyOptions;

/// Reports what becomes of the maps of a robot that is lost.
class AtlasReporter {
 public:
  explicit AtlasReporter(const pipeline::RobotAtlas& atlas)
      : atlas_(atlas), joins_(atlas.joins()), changes_(atlas.changes()) {}

  void report() {
    if (std::exchange(joins_, atlas_.joins()) != atlas_.joins()) {
      console::print("relocalized in the previous map; the two maps are now one");
    } else if (changes_ != atlas_.changes()) {
      console::print(
          "sonar readings contradict the map (was the robot carried, or did a wheel slip?): "
          "starting a new map, keeping the old one");
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
std::unique_ptr<exploration::AtlasExplorer> explorer_of(const RobotContext& robot,
                                                        const ExploreRun& run,
                                                        std::mt19937& random) {
  const StrategyOptions& strategy = run.strategy;
  const auto make = [&](std::size_t stops_made) -> std::unique_ptr<exploration::Explorer> {
    StrategyOptions left = strategy;
    if (left.stops) {
      *left.stops -= std::min(*left.stops, stops_made / left.scans);
    }
    if (left.stops == 0U) {
      return nullptr;
    }
    return run.make_explorer ? run.make_explorer(left)
                             : strategies::explorer_for(robot.profile(), left, random);
  };
  return std::make_unique<exploration::AtlasExplorer>(
      make,
      robot.atlas().pipeline().snapshot().stops,
      !robot.is_followed() && strategies::begins_anywhere(strategy));
}

/// The fault that ends an exploration: no map can come of it.
std::optional<diagnosis::Fault> fatal_fault(const RobotContext& robot,
                                            const std::optional<FinishReason>& reason) {
  if (const auto found = robot.diagnosis(); found && forbids_a_map(found->fault.kind)) {
    return found->fault;
  }
  const auto wheel = robot.wheel_that_stood_still();
  return reason == FinishReason::kWheelFault && wheel ? std::optional(diagnosis::Fault{*wheel, 0.0})
                                                      : std::nullopt;
}

/// Of the fault that the ending names.
std::optional<exports::FaultSummary> fault_summary(const RobotContext& robot,
                                                   const std::optional<FinishReason>& reason) {
  const auto found = robot.diagnosis();
  const auto fatal = fatal_fault(robot, reason);
  if (fatal && (!found || fatal->kind != found->fault.kind)) {
    return exports::FaultSummary{name_of(fatal->kind)};
  }
  return summary_of(found);
}

/// Says once what is wrong with a robot that can go on.
class FaultReporter {
 public:
  explicit FaultReporter(const RobotContext& robot) : robot_(robot) {}

  void report() {
    const auto found = robot_.diagnosis();
    const bool is_told = robot_.dirty_encoder().has_value();
    if (found && !is_told && !forbids_a_map(found->fault.kind) && !std::exchange(has_told_, true)) {
      const session::FaultAdvice advice = advice_of(found->fault, robot_.profile());
      spdlog::warn("{}: {}", advice.what, advice.change);
    }
  }

 private:
  const RobotContext& robot_;
  bool has_told_ = false;
};

/// Motion by motion until the explorer has finished, the session has ended or the robot turns out
/// to be one that no map can come of.
std::optional<FinishReason> drive(RobotContext& robot,
                                  exploration::Explorer& explorer,
                                  RunWriter& writer) {
  MotionResult last = MotionResult::kReached;
  AtlasReporter maps(robot.atlas());
  FaultReporter faults(robot);
  while (!robot.session().end() && !fatal_fault(robot, std::nullopt)) {
    const auto motion = explorer.next(robot.atlas().pipeline().snapshot(), last);
    if (const auto* finished = std::get_if<exploration::Finished>(&motion)) {
      return finished->reason;
    }
    last = robot.execute(motion);
    maps.report();
    if (std::holds_alternative<exploration::EndScan>(motion)) {
      writer.save_in_passing();
      faults.report();
    }
  }
  return std::nullopt;
}

/// Connects, drives and stops the robot; answers why the explorer has finished, if it has.
std::optional<FinishReason> connect_and_drive(RobotContext& robot,
                                              exploration::Explorer& explorer,
                                              RunWriter& writer) {
  RobotSession& session = robot.session();
  session.look_around_on_the_way(robot.atlas().pipeline().slam() != nullptr);
  robot.connect();
  writer.begin();
  const auto reason = drive(robot, explorer, writer);
  session.end_scan();
  session.look_around_on_the_way(false);
  session.disarm();
  return reason;
}

void describe_run(const RobotContext& robot, const ExploreRun& run, exports::RunSummary& summary) {
  summary.outcome = "exploring";
  summary.echomap_version = ECHOMAP_VERSION;
  summary.robot = robot.profile().name;
  summary.slam = robot.slam();
  summary.strategy = run.strategy.name;
  summary.seed = robot.seed().number();
  if (run.resumed) {
    summary.resumed_stops = run.resumed->stops;
  }
}

/// On the live page; a robot that begins anywhere takes a person's word for having been moved.
void show(const RobotContext& robot,
          const ExploreRun& run,
          exploration::AtlasExplorer& explorer,
          const ExploreView& view) {
  if (!run.live.serves()) {
    return;
  }
  PersonsWord word;
  if (!robot.is_followed() && strategies::begins_anywhere(run.strategy)) {
    word.moved = [&explorer] { explorer.report_moved(); };
  }
  auto source =
      std::make_unique<AtlasSource>(robot.atlas(), &view, [&view] { return view.live_progress(); });
  source->more = run.show_more;
  run.live.show(std::move(source), word, true);
}

void warn_of_previous_maps(const pipeline::RobotAtlas& atlas) {
  if (const std::size_t previous = atlas.previous_maps().size(); previous > 0) {
    spdlog::warn(
        "the map covers only what came after the robot was carried or its wheels slipped; {} could "
        "not be aligned with it and is saved in {}",
        previous == 1 ? "the previous map" : "the previous maps",
        previous == 1 ? "previous_1" : "previous_1, previous_2, ...");
  }
}

/// The floor that the largest of the maps has that were set aside and not joined.
double previous_floor_m2(const RobotContext& robot) {
  double largest_m2 = 0.0;
  for (const pipeline::PreviousMap& previous : robot.atlas().previous_maps()) {
    const auto coverage = coverage_of(previous.pipeline.snapshot(), robot.profile());
    largest_m2 = std::max(largest_m2, coverage ? coverage->seen_m2 : 0.0);
  }
  return largest_m2;
}

RunEnding ending_of_exploration(const RobotContext& robot,
                                const std::optional<FinishReason>& reason,
                                const std::optional<exploration::Coverage>& coverage,
                                const std::optional<mapping::ExpectedWallError>& walls,
                                const NextCommands& next) {
  const RobotSession& session = robot.session();
  if (const auto fault = fatal_fault(robot, reason)) {
    return ending_of_fault(advice_of(*fault, robot.profile()), next.again);
  }
  RunEnding ending = reason ? ending_of(*reason, coverage, walls, next)
                            : ending_of(session.end().value_or(session::SessionEnd::kLinkLost),
                                        session.end_reason(),
                                        next);
  if (coverage) {
    ending =
        with_previous_map(std::move(ending), previous_floor_m2(robot), coverage->seen_m2, next);
  }
  const auto found = robot.diagnosis();
  return found ? with_fault(std::move(ending), advice_of(found->fault, robot.profile())) : ending;
}

/// A run whose end is not saved has no closing paragraph: what is there is of an earlier stop.
void save_at_the_end(RunWriter& writer) {
  try {
    writer.save();
  } catch (const files::FileError& error) {
    throw files::FileError(
        "the run is not saved, or only up to an earlier stop: " + std::string(error.what()) +
        "\n  next: make room there, or name another directory with --out; then start again");
  }
}

}  // namespace

RobotProfile profile_for(const std::string& robot, const StrategyOptions& strategy) {
  RobotProfile profile = session::load_robot_profile(robot);
  strategies::validate_fit(profile, strategy);
  return profile;
}

void validate_slam(const RunOptions& run, const RobotProfile& profile) {
  if (run.slam_is_named && run.slam != session::kNoSlam && !profile.has_sonar) {
    throw CommandError(ExitCode::kUsage,
                       "--slam " + run.slam + " needs a sonar, and profile '" + profile.name +
                           "' has none: it is placed by its odometry\n  next: leave out --slam");
  }
}

void begin_maps(RobotContext& robot, const std::string& fixes, const std::string& slam) {
  robot.begin_maps(fixes.empty() ? slam : session::kNoSlam);
  robot.follow(tracking::camera_at(fixes, robot.profile(), robot.atlas(), robot.fork()));
}

void open_port(RobotContext& robot,
               const session::ConnectionOptions& connection,
               const StrategyOptions& strategy,
               exports::RunSummary& summary) {
  session::OpenedRobot opened = session::open_robot(connection, robot.seed());
  opened.connection.may_be_lifted = !robot.is_followed() && strategies::begins_anywhere(strategy);
  if (opened.lockstep) {
    summary.firmware = opened.lockstep->device().firmware;
    summary.emulator = opened.lockstep->device().emulator;
  }
  robot.open(std::move(opened));
}

RunEnding explore_and_save(RobotContext& robot,
                           const ExploreRun& run,
                           exports::RunSummary& summary) {
  describe_run(robot, run, summary);
  std::mt19937 random = robot.seed().generator(session::SeedPurpose::kStrategy);
  const auto explorer = explorer_of(robot, run, random);
  RunWriter writer(robot, *explorer, run, summary);
  ExploreView view(robot, run, *explorer);
  show(robot, run, *explorer, view);
  SessionProgress progress(robot, view, run.display);
  const auto reason = connect_and_drive(robot, view, writer);
  progress.finish();
  run.live.show_nothing();
  warn_of_previous_maps(robot.atlas());
  const auto coverage =
      coverage_of(run.known ? run.known() : robot.atlas().pipeline().snapshot(), robot.profile());
  const auto walls = wall_error_of(robot.atlas().pipeline());
  RunEnding ending = ending_of_exploration(robot, reason, coverage, walls, run.next);
  describe_ending(ending, summary);
  describe_walls(walls, summary);
  if (coverage) {
    summary.coverage = summary_of(*coverage);
  }
  summary.robot_fault = fault_summary(robot, reason);
  save_at_the_end(writer);
  return ending;
}

}  // namespace echomap::apps
