// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "host/pipeline/joined_sessions.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::apps {

/// What a run had come to when it ended.
struct ResumedRun {
  std::size_t stops = 0;
  double sim_seconds = 0.0;
};

/// The robot's time in a run before this one, if there was any.
inline double sim_seconds_of(const std::optional<ResumedRun>& run) {
  return run ? run->sim_seconds : 0.0;
}

/// Whether a run has left its record and the profile of its robot in that directory.
bool is_recorded_run(const std::filesystem::path& path);

/// Hands a record to `sink`. Warns of one whose writer was killed. Throws files::FileError where it
/// is damaged; what comes before is handed on. Throws CommandError at an interrupt.
void play_record(const std::filesystem::path& record, pipeline::ObservationSink& sink);

/// Hands the record of the run in that directory to `sink`, which leads to `atlas`, and those of
/// its previous maps to the atlas. Of a damaged record it hands on what comes before the damage;
/// after the last record it throws files::FileError, which names every damaged one.
void play_run(const std::filesystem::path& run,
              pipeline::ObservationSink& sink,
              pipeline::RobotAtlas& atlas);

/// Hands the record of the run in that directory to `sessions`, which lead to `atlas`, and those of
/// its previous maps to the atlas, and begins the next session there; does nothing for an empty
/// path. Reads only. Throws CommandError 2 where the run has no record or is of another robot, and
/// files::FileError where its files are damaged.
std::optional<ResumedRun> resume_run(const std::filesystem::path& run,
                                     const session::RobotProfile& profile,
                                     pipeline::JoinedSessions& sessions,
                                     pipeline::RobotAtlas& atlas);

}  // namespace echomap::apps
