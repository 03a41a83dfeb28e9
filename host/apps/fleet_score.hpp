// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "host/apps/fleet_watch.hpp"
#include "host/exports/summary_json.hpp"
#include "host/fleet_member/team_picture.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/session/robot_profile.hpp"
#include "host/team_map/merged_map.hpp"

namespace echomap::apps {

/// Where the truth of a simulated fleet's robot is, of one alone too.
std::filesystem::path truth_folder(const std::filesystem::path& out, const std::string& robot);

/// Writes the map of a simulated fleet to `out`/team, in the frame of its first robot, whose path
/// in `out`/robot0 is its path. Throws files::FileError.
void save_fleet_map(const pipeline::Snapshot& snapshot,
                    const team_map::MergedMap& merged,
                    const session::RobotProfile& profile,
                    const std::filesystem::path& out,
                    const exports::RunSummary& summary);

/// What a simulated fleet has come to: of each robot how it ended, what meeting others led to and
/// how its map lies to the first one's, against the truth; how the fleet came to one map, and the
/// scores of the map of all. What there is no truth of is null.
nlohmann::ordered_json fleet_report(const std::vector<std::string>& robots,
                                    const FleetWatch& watch,
                                    const fleet_member::TeamPicture& picture,
                                    const std::filesystem::path& out);

}  // namespace echomap::apps
