// SPDX-License-Identifier: MIT
#include "host/apps/resumed_run.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "host/apps/recorded_run.hpp"
#include "host/apps/report.hpp"
#include "host/console/exit_code.hpp"
#include "host/console/print.hpp"
#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "host/recording/session_file.hpp"

namespace echomap::apps {
namespace {

using console::CommandError;
using console::ExitCode;
using session::RobotProfile;

namespace fs = std::filesystem;

fs::path recording_in(const fs::path& run) {
  const auto recording = recording_of(run);
  if (!recording) {
    const bool is_old = exists(run / "observations.csv");
    throw CommandError(ExitCode::kUsage,
                       "cannot resume " + run.string() + ": it has no " +
                           recording::kSessionFileName +
                           (is_old ? ", an earlier version of echomap made it" : "") +
                           "\n  next: name the run directory of echomap explore with --resume");
  }
  return *recording;
}

void validate_same_robot(const fs::path& run,
                         const std::string& robot,
                         const RobotProfile& profile) {
  if (robot != profile.name) {
    throw CommandError(ExitCode::kUsage,
                       "cannot resume " + run.string() + ": its robot is '" + robot + "', not '" +
                           profile.name + "'\n  next: name that robot's profile with --robot");
  }
}

}  // namespace

std::optional<ResumedRun> resume_run(const fs::path& run, session::RobotContext& robot) {
  if (run.empty()) {
    return std::nullopt;
  }
  recording::SessionReader recording(recording_in(run));
  validate_same_robot(run, profile_of(recording).name, robot.profile());
  const Played played = play(recording,
                             robot.profile(),
                             {robot.sessions(), robot.fork(), &robot.atlas(), &robot.recorder()});
  if (!played.damage.empty()) {
    throw files::FileError(played.damage);
  }
  robot.begin_next_session();
  const auto snapshot = robot.atlas().pipeline().snapshot();
  if (snapshot.trajectory->empty()) {
    throw CommandError(ExitCode::kUsage,
                       "cannot resume " + run.string() +
                           ": its recording is empty\n  next: name another run, or start again");
  }
  if (snapshot.times_lifted > 0) {
    throw CommandError(ExitCode::kUsage,
                       "cannot resume " + run.string() +
                           ": the robot was lifted during the run and its pose is lost\n  next: "
                           "start again without --resume");
  }
  robot.recorder().add_map(snapshot);
  exports::RunSummary summary;
  exports::describe_snapshot(snapshot, summary);
  console::print(fmt::format("resuming {}: {} stop{}, {:.1f} m² mapped",
                             run.string(),
                             summary.stops,
                             summary.stops == 1 ? "" : "s",
                             summary.free_area_m2));
  return ResumedRun{summary.stops, played.duration_s};
}

}  // namespace echomap::apps
