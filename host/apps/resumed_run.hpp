// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "host/session/robot_context.hpp"

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

/// Plays the recording of the run in that directory into the robot's maps and its new recording,
/// and begins the next session there; does nothing for an empty path. Reads only. Throws
/// CommandError 2 where the run has no recording or is of another robot, and files::FileError where
/// its files are damaged.
std::optional<ResumedRun> resume_run(const std::filesystem::path& run,
                                     session::RobotContext& robot);

}  // namespace echomap::apps
