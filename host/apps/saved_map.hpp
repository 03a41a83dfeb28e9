// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

#include "host/exports/run_directory.hpp"
#include "host/exports/summary_json.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::apps {

/// The record of a run, in its directory.
inline constexpr const char* kRecordName = "observations.csv";
/// The record of the run that had the directory before.
inline constexpr const char* kPreviousRecordName = "observations.before.csv";
/// The profile of the robot that drove, as it was then.
inline constexpr const char* kProfileName = "robot.toml";

/// The folder that a run writes a map into that was set aside, in its directory: 1 is the earliest.
std::filesystem::path previous_map_of(const std::filesystem::path& run, std::size_t number);

/// The folder to read that map from: `previous_map_of`, or the one that an older version of echomap
/// wrote where only that one exists.
std::filesystem::path stored_previous_map(const std::filesystem::path& run, std::size_t number);

/// Renames the record and the previous maps of an earlier run in the same directory, and removes
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
