// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

#include "host/exports/run_directory.hpp"
#include "host/exports/summary_json.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::apps {

/// The recording of the run that had a directory before.
inline constexpr const char* kPreviousRecordingName = "session.before.mcap";
/// The profile of the robot that drove, as it was then.
inline constexpr const char* kProfileName = "robot.toml";

/// The folder that a run writes a map into that was set aside, in its directory: 1 is the earliest.
std::filesystem::path previous_map_of(const std::filesystem::path& run, std::size_t number);

/// Renames the recording and the previous maps of an earlier run in the same directory, and removes
/// those of its files that the next run might not write. Throws files::FileError.
void move_earlier_run_aside(const std::filesystem::path& out);

/// Writes the map of a pipeline into its run directory, with the pose graph of its SLAM and the
/// profile of its robot, and fills in what `summary` says of the map. The robot's radius in
/// `drawing` is the profile's. Throws files::FileError.
void save_map(const pipeline::RobotPipeline& pipeline,
              const session::RobotProfile& profile,
              const std::filesystem::path& folder,
              exports::RunSummary& summary,
              exports::RunDrawing drawing = {});

}  // namespace echomap::apps
