// SPDX-License-Identifier: MIT
#include <string>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/commands.hpp"
#include "host/apps/explore_progress.hpp"
#include "host/apps/localize_places.hpp"
#include "host/apps/localize_run.hpp"
#include "host/apps/map_file.hpp"
#include "host/apps/recorded_run.hpp"
#include "host/apps/report.hpp"
#include "host/apps/run_ending.hpp"
#include "host/apps/whole_records.hpp"
#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"
#include "host/console/progress_bar.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "host/pipeline/log_player.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/pipeline/robot_localizer.hpp"
#include "host/session/robot_profile.hpp"
#include "host/session/seed.hpp"
#include "host/tracking/localize_troubles.hpp"
#include "host/tracking/mcl_filter.hpp"
#include "host/tracking/pose_report.hpp"

namespace echomap::apps {
namespace {

/// Prints the status whenever it changes.
class StatusLine {
 public:
  void report(const localization::PoseBelief& belief, std::size_t scans) {
    if (belief.status == last_ || belief.hypotheses.empty()) {
      return;
    }
    last_ = belief.status;
    console::print(fmt::format("  scan {}: {}", scans, tracking::text_of(belief)));
  }

 private:
  localization::LocalizationStatus last_ = localization::LocalizationStatus::kRecovering;
};

/// Hands observations to the localizer, and prints changes of its status after each stop.
class ReportingSink final : public pipeline::AnyObservationSink {
 public:
  explicit ReportingSink(pipeline::RobotLocalizer& localizer) : localizer_(localizer) {}

  void on(const sensors::Observation& observation) override {
    pipeline::hand_on(observation, localizer_);
    if (std::holds_alternative<sensors::EndScan>(observation)) {
      status_.report(localizer_.belief(), localizer_.scans());
    }
  }

 private:
  pipeline::RobotLocalizer& localizer_;
  StatusLine status_;
};

/// Plays the log of another robot until it ends or the user has had enough; answers whether it
/// ended.
bool play(datasets::LogReader& log,
          pipeline::RobotLocalizer& localizer,
          console::ProgressBar& progress) {
  StatusLine status;
  pipeline::LogPlayer player(localizer);
  while (!console::interrupted()) {
    const auto record = next_whole_record(log);
    if (!record) {
      return true;
    }
    const std::size_t updates = localizer.updates();
    player.play(*record);
    if (localizer.updates() != updates) {
      progress.show(log.progress(), fmt::format("{} scans", localizer.scans()));
      status.report(localizer.belief(), localizer.scans());
    }
  }
  return false;
}

/// How a log was played: "finished", "interrupted" or "log-damaged", and by what.
struct Outcome {
  std::string name;
  std::string damage{};
};

/// Plays what a run has recorded.
Outcome play(recording::SessionReader& recording,
             const session::RobotProfile& profile,
             pipeline::RobotLocalizer& localizer) {
  ReportingSink sink(localizer);
  pipeline::JoinedSessions sessions(sink);
  const Played played = apps::play(recording, profile, {sessions, sink});
  return {played.damage.empty() ? "finished" : "log-damaged", played.damage};
}

/// Plays the log of another robot.
Outcome play(const LocalizeOptions& options, pipeline::RobotLocalizer& localizer) {
  console::ProgressBar progress(stderr, progress_display(options.run) != ProgressDisplay::kNone);
  try {
    const auto log = open_reported_log(options.log, options.format);
    const bool has_ended = play(*log, localizer, progress);
    progress.clear();
    return {has_ended ? "finished" : "interrupted"};
  } catch (const files::FileError& error) {
    progress.clear();
    return {"log-damaged", error.what()};
  }
}

RunEnding ending_of_log(const LocalizeOptions& options,
                        const std::string& outcome,
                        const std::string& damage,
                        const pipeline::RobotLocalizer& localizer) {
  if (outcome != "finished") {
    return ending_of_replay(outcome, damage, options.map.string());
  }
  const console::CommandWords words{
      "echomap", "localize", options.log.string(), "--map", options.map.string()};
  return ending_of_preset(
      options.preset,
      ending_of_localization(outcome, tracking::to_json(localizer.belief()), words),
      words);
}

nlohmann::ordered_json log_report(const LocalizeOptions& options,
                                  const RunEnding& ending,
                                  const pipeline::RobotLocalizer& localizer) {
  nlohmann::ordered_json json = to_json(ending);
  json.update({{"log", options.log.filename().string()},
               {"scans", localizer.scans()},
               {"unused_scans", localizer.unused_scans()},
               {"late_scans", localizer.late_scans()},
               {"updates", localizer.updates()},
               {"times_lifted", localizer.times_lifted()}});
  json.update(tracking::to_json(localizer.belief()));
  return json;
}

ExitCode report_on(const LocalizeOptions& options,
                   const std::filesystem::path& out,
                   const Outcome& outcome,
                   const pipeline::RobotLocalizer& localizer) {
  if (localizer.scans() == 0 || localizer.belief().hypotheses.empty()) {
    throw CommandError(ExitCode::kRuntimeError,
                       outcome.damage.empty()
                           ? tracking::why_nowhere(localizer, options.log, options.map)
                           : outcome.damage);
  }
  for (const std::string& trouble : tracking::troubles_of(localizer)) {
    spdlog::warn("{}", trouble);
  }
  exports::write_trajectory_tum(out / "trajectory.tum", localizer.trajectory());
  const RunEnding ending = ending_of_log(options, outcome.name, outcome.damage, localizer);
  const auto report = log_report(options, ending, localizer);
  write_report(out / "summary.json", report);
  write_report(options.run.json, report);
  console::print(
      fmt::format("{} scans: {}", localizer.scans(), tracking::text_of(localizer.belief())));
  console::print("trajectory: " + (out / "trajectory.tum").string());
  print_ending(ending, "the trajectory up to there");
  return ending.code;
}

void start(const LocalizeOptions& options, pipeline::RobotLocalizer& localizer) {
  if (const auto start = tracking::start_pose(options.at)) {
    localizer.start_at(start->T_map_robot, start->stddev_m, start->stddev_rad);
  }
}

/// A run is played as its robot reported it, unless the log's format is asked for.
ExitCode localize_recording(const LocalizeOptions& options,
                            const std::filesystem::path& file,
                            const std::filesystem::path& out) {
  recording::SessionReader recording(file);
  const session::RobotProfile profile = profile_of(recording);
  pipeline::RobotLocalizer localizer(
      read_map(options.map),
      profile.geometry,
      localizer_params(profile, options),
      session::Seed(options.run.seed).generator(session::SeedPurpose::kLocalizer));
  start(options, localizer);
  return report_on(options, out, play(recording, profile, localizer), localizer);
}

ExitCode localize_log(const LocalizeOptions& options, const std::filesystem::path& out) {
  const auto recording =
      options.format.empty() ? recording_of(options.log) : std::optional<std::filesystem::path>();
  if (recording) {
    return localize_recording(options, *recording, out);
  }
  if (options.preset == localization::LocalizerPreset::kCreate) {
    throw CommandError(ExitCode::kUsage,
                       "preset 'create' localizes by contacts, and a log is played for its ranges\n"
                       "  next: leave --preset out, or localize the recording of a Create");
  }
  pipeline::RobotLocalizerParams params;
  set_filter(options, params);
  pipeline::RobotLocalizer localizer(
      read_map(options.map),
      {},
      params,
      session::Seed(options.run.seed).generator(session::SeedPurpose::kLocalizer));
  start(options, localizer);
  return report_on(options, out, play(options, localizer), localizer);
}

}  // namespace

ExitCode run_localize(const LocalizeOptions& options) {
  const auto out = run_folder(options.run.out);
  prepare_outputs(out, options.run.json, options.run.force);
  if (places_of(options.map)) {
    return localize_in_places(options, out);
  }
  return options.log.empty() ? localize_robot(options, out) : localize_log(options, out);
}

}  // namespace echomap::apps
