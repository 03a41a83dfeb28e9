// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "host/pipeline/joined_sessions.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::apps {

/// The record of a run, in its directory.
inline constexpr const char* kRecordName = "observations.csv";
/// That of the run that had the directory before.
inline constexpr const char* kFormerRecordName = "observations.before.csv";

/// What a run had come to when it ended.
struct ResumedRun {
  std::size_t stops = 0;
  double sim_seconds = 0.0;
};

/// The robot's time in a run before this one, if there was any.
inline double sim_seconds_of(const std::optional<ResumedRun>& run) {
  return run ? run->sim_seconds : 0.0;
}

/// The folder of a run's map that was set aside, in its directory: 1 is the earliest.
std::filesystem::path former_map_of(const std::filesystem::path& run, std::size_t number);

/// Hands the record of the run in that directory to `sessions`, which lead to `atlas`, and those of
/// its former maps to the atlas, and begins the next session there; does nothing for an empty path.
/// Reads only. Throws CommandError 2 where the run has no record or is of another robot, and
/// files::FileError where its files are damaged.
std::optional<ResumedRun> resume_run(const std::filesystem::path& run,
                                     const session::RobotProfile& profile,
                                     pipeline::JoinedSessions& sessions,
                                     pipeline::RobotAtlas& atlas);

}  // namespace echomap::apps
