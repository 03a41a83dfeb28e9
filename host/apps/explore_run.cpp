// SPDX-License-Identifier: MIT
#include "host/apps/explore_run.hpp"

#include <chrono>
#include <random>
#include <string>
#include <system_error>
#include <utility>
#include <variant>

#include <spdlog/spdlog.h>

#include "host/apps/explore_progress.hpp"
#include "host/apps/link_report.hpp"
#include "host/apps/strategy_setup.hpp"
#include "host/exports/confidence_grid_csv.hpp"
#include "host/exports/pose_graph_g2o.hpp"
#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::apps {
namespace {

using exploration::MotionResult;

/// What was there before this run.
ResumedRun before(const DrivenRobot& robot) { return robot.resumed.value_or(ResumedRun{}); }

/// Of the robot's time, that of the run that it resumes included.
double elapsed_s(const DrivenRobot& robot) {
  const std::chrono::duration<double> session = robot.session.now().time_since_epoch();
  return before(robot).sim_seconds + session.count();
}

/// Saves the map so far, with how far the exploration has come.
class RunKeeper {
 public:
  RunKeeper(const DrivenRobot& robot,
            const exploration::Explorer& explorer,
            std::filesystem::path out,
            exports::RunSummary& summary)
      : robot_(robot), explorer_(explorer), out_(std::move(out)), summary_(summary) {}

  void save(const std::string& outcome) {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
    const auto snapshot = robot_.pipeline.snapshot();
    summary_.outcome = outcome;
    summary_.sim_seconds = elapsed_s(robot_);
    summary_.wall_seconds = wall.count();
    describe_clock();
    describe_link();
    exports::describe_snapshot(snapshot, summary_);
    save_record();
    if (const slam::SlamMethod* slam = robot_.pipeline.slam()) {
      exports::describe_uncertainty(slam->belief().covariance, summary_);
      exports::write_pose_graph_g2o(out_ / "pose_graph.g2o", slam->factor_graph());
    } else {
      std::filesystem::remove(out_ / "pose_graph.g2o");
    }
    const exploration::StrategyProducts products = explorer_.products();
    if (products.phases > 0) {
      summary_.phases = products.phases;
      summary_.phases_reached = products.phases_reached;
    }
    exports::write_run_directory(out_, snapshot, summary_, products.outline_m);
    if (products.confidence) {
      exports::write_confidence_grid_csv(out_ / "confidence_grid.csv", *products.confidence);
    }
  }

  /// A disk that is full now need not be so at the end: warns once and lets the robot go on.
  void save_in_passing() {
    try {
      save("exploring");
    } catch (const files::FileError& error) {
      if (!std::exchange(warned_, true)) {
        spdlog::warn("the map so far is not saved: {}", error.what());
      }
    }
  }

 private:
  void describe_clock() {
    const time::ClockSync& clock = robot_.session.link().clock();
    summary_.clock_rate_error_ppm = clock.rate_error_ppm();
    summary_.clock_uncertainty_us = clock.uncertainty_us();
    if (summary_.clock_rate_error_ppm && summary_.clock_uncertainty_us) {
      spdlog::debug("the robot's clock runs {:+.1f} ppm fast, known to {:.0f} us",
                    *summary_.clock_rate_error_ppm,
                    *summary_.clock_uncertainty_us);
    }
  }

  void describe_link() {
    const auto link = summary_of(robot_.session.link().statistics(), robot_.session.reconnects());
    spdlog::debug("{}", line_of(link));
    if (const auto losses = losses_between(summary_.link, link); !losses.empty()) {
      spdlog::warn("since the last stop the robot has counted {}", losses);
    }
    summary_.link = link;
    if (const auto& robot = robot_.session.link().robot(); robot && summary_.firmware.empty()) {
      summary_.firmware = firmware_of(*robot);
    }
  }

  /// The record of a former run in the same directory stays beside it.
  void save_record() {
    const std::filesystem::path record = out_ / kRecordName;
    if (!std::exchange(former_is_kept_, true) && exists(record)) {
      std::error_code failure;
      std::filesystem::rename(record, out_ / kFormerRecordName, failure);
      if (failure) {
        throw files::FileError(record.string() + " is in the way: " + failure.message());
      }
    }
    robot_.recorder.save(record);
  }

  const DrivenRobot& robot_;
  const exploration::Explorer& explorer_;
  std::filesystem::path out_;
  exports::RunSummary& summary_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool warned_ = false;
  bool former_is_kept_ = false;
};

/// Of the whole map, as the summary is.
std::string progress_line(const DrivenRobot& robot, const RunOptions& options) {
  exports::RunSummary summary;
  exports::describe_snapshot(robot.pipeline.snapshot(), summary);
  ExploreProgress progress;
  progress.stops = summary.stops;
  progress.floor_m2 = summary.free_area_m2;
  progress.travelled_m = summary.travelled_m;
  progress.elapsed_s = elapsed_s(robot);
  switch (limit_of(options)) {
    case StrategyLimit::kStops:
      progress.most_stops = before(robot).stops + options.stops * options.scans;
      break;
    case StrategyLimit::kSeconds:
      progress.most_s = before(robot).sim_seconds + options.seconds;
      break;
    case StrategyLimit::kNone:
      break;
  }
  return line_of(progress);
}

/// For a strategy, which counts its own stops.
pipeline::Snapshot snapshot_of_this_run(const DrivenRobot& robot) {
  pipeline::Snapshot snapshot = robot.pipeline.snapshot();
  snapshot.stops -= before(robot).stops;
  return snapshot;
}

/// Motion by motion until the explorer has finished or the session has ended.
std::optional<exploration::FinishReason> drive(const DrivenRobot& robot,
                                               exploration::Explorer& explorer,
                                               RunKeeper& keeper) {
  MotionResult last = MotionResult::kReached;
  while (!robot.session.end()) {
    const auto motion = explorer.next(snapshot_of_this_run(robot), last);
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
  summary.strategy = options.strategy;
  summary.seed = options.seed;
  if (robot.resumed) {
    summary.resumed_stops = robot.resumed->stops;
  }
}

/// Of a session that has ended before its strategy had.
ExitCode save_what_is_left(RobotSession& session, RunKeeper& keeper) {
  spdlog::error("the map so far is kept, for {}", session.end_reason());
  const SessionEnd end = session.end().value_or(SessionEnd::kLinkLost);
  keeper.save(outcome_of(end));
  return exit_code_of(end);
}

}  // namespace

RobotProfile profile_for(const RunOptions& options) {
  RobotProfile profile = load_robot_profile(options.robot);
  require_fit(profile, options);
  return profile;
}

ExitCode explore_and_save(const DrivenRobot& robot,
                          const RunOptions& options,
                          const std::filesystem::path& out,
                          exports::RunSummary& summary) {
  RobotSession& session = robot.session;
  CameraFollower* const camera = robot.camera;
  describe_run(robot, options, summary);
  std::mt19937 random(options.seed);
  const auto explorer = explorer_for(robot.profile, options, random);
  RunKeeper keeper(robot, *explorer, out, summary);
  ProgressTeller progress(stderr, !options.headless);
  session.on_step = [&, steps = 0]() mutable {
    constexpr int kStepsPerDrawing = 64;
    if (camera != nullptr) {
      camera->poll(session);
    }
    if (++steps % kStepsPerDrawing == 0) {
      progress.tell(elapsed_s(robot), [&] { return progress_line(robot, options); });
    }
  };

  session.connect();
  if (camera != nullptr) {
    camera->begin(session);
  }
  const auto reason = drive(robot, *explorer, keeper);
  session.end_scan();
  session.disarm();
  session.on_step = nullptr;
  progress.clear();
  if (reason) {
    keeper.save(exploration::name_of(*reason));
    return exit_code_of(*reason);
  }
  return save_what_is_left(session, keeper);
}

}  // namespace echomap::apps
