// SPDX-License-Identifier: MIT
#include "host/apps/resumed_run.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/report.hpp"
#include "host/apps/saved_map.hpp"
#include "host/console/exit_code.hpp"
#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"
#include "host/exports/observations_csv.hpp"
#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "host/pipeline/observation_sink.hpp"

namespace echomap::apps {
namespace {

using console::CommandError;
using console::ExitCode;
using session::RobotProfile;

/// Of the summary of a run.
struct RunFacts {
  std::string robot;
  double sim_seconds = 0.0;
};

RunFacts read_facts(const std::filesystem::path& summary) {
  const auto json = nlohmann::json::parse(files::read_text_file(summary), nullptr, false);
  try {
    return {json.at("robot").get<std::string>(), json.at("sim_seconds").get<double>()};
  } catch (const nlohmann::json::exception&) {
    throw files::FileError(summary.string() +
                           ": not the summary of a run: robot or sim_seconds is missing");
  }
}

void validate_record(const std::filesystem::path& run) {
  if (!std::filesystem::exists(run / kRecordName)) {
    throw CommandError(ExitCode::kUsage,
                       "cannot resume " + run.string() + ": it has no " + kRecordName +
                           "\n  next: name the run directory of echomap explore with --resume");
  }
}

void validate_same_robot(const std::filesystem::path& run,
                         const std::string& robot,
                         const RobotProfile& profile) {
  if (robot != profile.name) {
    throw CommandError(ExitCode::kUsage,
                       "cannot resume " + run.string() + ": its robot is '" + robot + "', not '" +
                           profile.name + "'\n  next: name that robot's profile with --robot");
  }
}

/// Ends the command where the user has had enough.
class InterruptibleSink final : public pipeline::AnyObservationSink {
 public:
  InterruptibleSink(pipeline::ObservationSink& sink, const std::filesystem::path& record)
      : sink_(sink), record_(record) {}

  void on(const sensors::Observation& observation) override {
    if (console::interrupted()) {
      throw CommandError(ExitCode::kInterrupted,
                         "interrupted in " + record_.string() + "; nothing was written");
    }
    pipeline::hand_on(observation, sink_);
  }

 private:
  pipeline::ObservationSink& sink_;
  const std::filesystem::path& record_;
};

/// Plays a record up to where it is damaged; answers how it is, empty where it is whole.
std::string damage_of(const std::filesystem::path& record, pipeline::ObservationSink& sink) {
  try {
    play_record(record, sink);
    return "";
  } catch (const files::FileError& error) {
    return error.what();
  }
}

}  // namespace

bool is_recorded_run(const std::filesystem::path& path) {
  return std::filesystem::is_directory(path) && exists(path / kRecordName) &&
         exists(path / kProfileName);
}

void play_record(const std::filesystem::path& record, pipeline::ObservationSink& sink) {
  InterruptibleSink interruptible(sink, record);
  if (exports::replay_observations_csv(record, interruptible)) {
    spdlog::warn("the last line of {} is incomplete; everything before it was read",
                 record.string());
  }
}

void play_run(const std::filesystem::path& run,
              pipeline::ObservationSink& sink,
              pipeline::RobotAtlas& atlas) {
  std::string damage = damage_of(run / kRecordName, sink);
  for (std::size_t number = 1; exists(stored_previous_map(run, number)); ++number) {
    pipeline::ObservationLog previous;
    const std::string more = damage_of(stored_previous_map(run, number) / kRecordName, previous);
    damage += (damage.empty() || more.empty() ? "" : "\n") + more;
    atlas.set_aside(std::move(previous));
  }
  if (!damage.empty()) {
    throw files::FileError(damage);
  }
}

std::optional<ResumedRun> resume_run(const std::filesystem::path& run,
                                     const RobotProfile& profile,
                                     pipeline::JoinedSessions& sessions,
                                     pipeline::RobotAtlas& atlas) {
  if (run.empty()) {
    return std::nullopt;
  }
  validate_record(run);
  const RunFacts facts = read_facts(run / "summary.json");
  validate_same_robot(run, facts.robot, profile);
  play_run(run, sessions, atlas);
  sessions.begin_next();
  const auto snapshot = atlas.pipeline().snapshot();
  if (snapshot.trajectory->empty()) {
    throw CommandError(ExitCode::kUsage,
                       "cannot resume " + run.string() +
                           ": its record is empty\n  next: name another run, or start again");
  }
  if (snapshot.times_lifted > 0) {
    throw CommandError(ExitCode::kUsage,
                       "cannot resume " + run.string() +
                           ": the robot was lifted during the run and its pose is lost\n  next: "
                           "start again without --resume");
  }
  exports::RunSummary summary;
  exports::describe_snapshot(snapshot, summary);
  console::print(fmt::format("resuming {}: {} stop{}, {:.1f} m² mapped",
                             run.string(),
                             summary.stops,
                             summary.stops == 1 ? "" : "s",
                             summary.free_area_m2));
  return ResumedRun{summary.stops, facts.sim_seconds};
}

}  // namespace echomap::apps
