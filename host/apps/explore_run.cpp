// SPDX-License-Identifier: MIT
#include "host/apps/explore_run.hpp"

#include <chrono>
#include <random>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "host/apps/link_report.hpp"
#include "host/apps/progress_bar.hpp"
#include "host/apps/strategy_setup.hpp"
#include "host/exploration/nxt_farthest.hpp"
#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::apps {
namespace {

using exploration::MotionResult;

double seconds_of(time::HostTime at) {
  return std::chrono::duration<double>(at.time_since_epoch()).count();
}

/// Saves the map so far, with how far the exploration has come.
class RunKeeper {
 public:
  RunKeeper(const RobotSession& session,
            const pipeline::RobotPipeline& pipeline,
            std::filesystem::path out,
            exports::RunSummary& summary)
      : session_(session), pipeline_(pipeline), out_(std::move(out)), summary_(summary) {}

  void save(const std::string& outcome) {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
    const auto snapshot = pipeline_.snapshot();
    summary_.outcome = outcome;
    summary_.sim_seconds = seconds_of(session_.now());
    summary_.wall_seconds = wall.count();
    describe_clock();
    describe_link();
    exports::describe_snapshot(snapshot, summary_);
    exports::write_run_directory(out_, snapshot, summary_);
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
    const time::ClockSync& clock = session_.link().clock();
    summary_.clock_rate_error_ppm = clock.rate_error_ppm();
    summary_.clock_uncertainty_us = clock.uncertainty_us();
    if (summary_.clock_rate_error_ppm && summary_.clock_uncertainty_us) {
      spdlog::debug("the robot's clock runs {:+.1f} ppm fast, known to {:.0f} us",
                    *summary_.clock_rate_error_ppm,
                    *summary_.clock_uncertainty_us);
    }
  }

  void describe_link() {
    const auto link = summary_of(session_.link().statistics(), session_.reconnects());
    spdlog::debug("{}", line_of(link));
    if (const auto losses = losses_between(summary_.link, link); !losses.empty()) {
      spdlog::warn("since the last stop the robot has counted {}", losses);
    }
    summary_.link = link;
    if (const auto& robot = session_.link().robot(); robot && summary_.firmware.empty()) {
      summary_.firmware = firmware_of(*robot);
    }
  }

  const RobotSession& session_;
  const pipeline::RobotPipeline& pipeline_;
  std::filesystem::path out_;
  exports::RunSummary& summary_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool warned_ = false;
};

void show_progress(ProgressBar& progress,
                   const pipeline::Snapshot& snapshot,
                   std::size_t most_stops,
                   time::HostTime now) {
  progress.show(static_cast<double>(snapshot.stops) / static_cast<double>(most_stops),
                fmt::format("stop {} of at most {}, {} echoes, {:.0f} s of robot time",
                            snapshot.stops,
                            most_stops,
                            snapshot.points->points().size(),
                            seconds_of(now)));
}

/// Motion by motion until the explorer has finished or the session has ended.
std::optional<exploration::FinishReason> drive(RobotSession& session,
                                               const pipeline::RobotPipeline& pipeline,
                                               exploration::Explorer& explorer,
                                               RunKeeper& keeper) {
  MotionResult last = MotionResult::kReached;
  while (!session.end()) {
    const auto motion = explorer.next(pipeline.snapshot(), last);
    if (const auto* finished = std::get_if<exploration::Finished>(&motion)) {
      return finished->reason;
    }
    last = session.execute(motion);
    if (std::holds_alternative<exploration::EndScan>(motion)) {
      keeper.save_in_passing();
    }
  }
  return std::nullopt;
}

ExitCode exit_code_of(exploration::FinishReason reason) {
  if (reason != exploration::FinishReason::kCannotSense) {
    return ExitCode::kOk;
  }
  spdlog::error(
      "no sweep of the sonar was carried out; the map so far is kept\n  next: check the pan drive "
      "and the sonar's wires");
  return ExitCode::kRuntimeError;
}

}  // namespace

RobotProfile profile_for(const RunOptions& options) {
  RobotProfile profile = load_robot_profile(options.robot);
  if (!profile.has_sonar) {
    throw CommandError(ExitCode::kConfigInvalid,
                       "strategy '" + options.strategy + "' needs a sonar, and profile '" +
                           profile.name +
                           "' has none\n  next: name another with --robot, as uno_2wd");
  }
  return profile;
}

ExitCode explore_and_save(const DrivenRobot& robot,
                          const RunOptions& options,
                          const std::filesystem::path& out,
                          exports::RunSummary& summary) {
  auto& [session, pipeline, profile] = robot;
  summary.echomap_version = ECHOMAP_VERSION;
  summary.robot = profile.name;
  summary.strategy = options.strategy;
  summary.seed = options.seed;
  std::mt19937 random(options.seed);
  exploration::NxtFarthest explorer(strategy_params(profile, options.stops), random);
  RunKeeper keeper(session, pipeline, out, summary);
  ProgressBar progress(stderr, !options.headless);
  if (progress.is_active()) {
    session.on_step = [&, steps = 0]() mutable {
      constexpr int kStepsPerDrawing = 64;
      if (++steps % kStepsPerDrawing == 0) {
        show_progress(progress, pipeline.snapshot(), options.stops, session.now());
      }
    };
  }

  session.connect();
  const auto reason = drive(session, pipeline, explorer, keeper);
  session.disarm();
  session.on_step = nullptr;
  progress.clear();
  if (reason) {
    keeper.save(exploration::name_of(*reason));
    return exit_code_of(*reason);
  }
  pipeline.end_scan();
  spdlog::error("the map so far is kept, for {}", session.end_reason());
  const SessionEnd end = session.end().value_or(SessionEnd::kLinkLost);
  keeper.save(outcome_of(end));
  return exit_code_of(end);
}

}  // namespace echomap::apps
