// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <nlohmann/json_fwd.hpp>

#include "host/apps/run_ending.hpp"
#include "host/fleet_member/search_view.hpp"
#include "host/source_search/source_belief.hpp"

namespace echomap::apps {

/// What a search has found, as source.json and the entry `source` of summary.json say it: that of
/// source_search::source_json, with the verdict "unsure" where it is undecided. Null: nothing was
/// read on any map, and that is all that is said.
nlohmann::ordered_json source_report(const source_search::SourceBelief* belief);

/// What another robot of a fleet has told of a source, as a source report: verdict, `told_by`, its
/// probability, and the place in the map that was asked for, null where the maps are not joined.
nlohmann::ordered_json told_report(const fleet_member::TeamFinding& told);

/// Adds `truth` to a source report: `sources` as the file source.json of a simulated robot's truth
/// has them in the map frame, `error_m` of the place that was found, whether the verdict is `right`
/// and the source `is_in_radius_95`; null where it is unsure. Does nothing where there is no such
/// file. Throws files::FileError and nlohmann::json::exception for a file that cannot be read.
void add_source_truth(const std::filesystem::path& truth_json, nlohmann::ordered_json& report);

/// How a search has ended whose drive ended so. A sure answer is finished, an unsure one is not;
/// what is wrong with the robot stays. `use` is the command to type with an answer, `go_on`
/// without.
RunEnding ending_of_search(RunEnding drive,
                           const nlohmann::ordered_json& report,
                           const NextCommands& next);

/// source_density.csv: x_m, y_m (map frame, middle of a cell of 5 cm) and probability density per
/// square metre of each cell that may hold the source. Throws files::FileError.
void write_source_density(const std::filesystem::path& path,
                          const source_search::SourceBelief& belief);

}  // namespace echomap::apps
