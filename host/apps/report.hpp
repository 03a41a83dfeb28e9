// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "host/evaluation/relation_error.hpp"
#include "host/evaluation/run_score.hpp"
#include "host/exports/summary_json.hpp"

namespace echomap::apps {

/// `chosen`, or where it is empty a new folder runs/TIME of the user's data folder
/// ($XDG_DATA_HOME/echomap, by default ~/.local/share/echomap).
std::filesystem::path run_folder(const std::filesystem::path& chosen);

/// Whether a folder holds what a run has written.
bool has_run(const std::filesystem::path& folder);

/// Throws CommandError 2 where the folder has a run that may not be replaced.
void refuse_to_replace_run(const std::filesystem::path& out, bool may_replace);

/// Makes the run folder and makes sure that it and the report's file, where there is one, can be
/// written: a run is not driven for nothing. Throws CommandError 2 where the folder has a run that
/// may not be replaced, and files::FileError.
void prepare_outputs(const std::filesystem::path& out,
                     const std::filesystem::path& json,
                     bool may_replace);

/// The radius of the robot that made a run, from the run's robot.toml; where it has none,
/// evaluation::kDefaultRobotRadiusM. Throws files::ConfigError.
double radius_of_robot(const std::filesystem::path& run);

/// The scores under the names that every report uses: free_iou, wall_rmse_m, ...
nlohmann::ordered_json to_json(const evaluation::RunScore& score);

/// The relation error: relations, relation_translation_mean_m, ...
nlohmann::ordered_json to_json(const evaluation::RelationError& error);

/// Writes `report` to the file, or to stdout for "-"; does nothing for an empty path. Throws
/// files::FileError.
void write_report(const std::filesystem::path& path, const nlohmann::ordered_json& report);

/// Prints the scores in one line each, those of the fitted map in brackets.
void print_score(const evaluation::RunScore& score);

/// The same for the relation error.
void print_relation_error(const evaluation::RelationError& error);

}  // namespace echomap::apps
