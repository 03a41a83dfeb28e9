// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "host/exports/summary_json.hpp"
#include "host/fleet_member/fleet_member.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/session/robot_profile.hpp"
#include "host/team_map/merged_map.hpp"

namespace echomap::apps {

/// Writes a team's map as a run directory. Throws files::FileError.
void save_team_map(const pipeline::Snapshot& snapshot,
                   const session::RobotProfile& profile,
                   const std::filesystem::path& folder,
                   exports::RunSummary summary);

/// Writes which robots have told of each cell that is known: a line of x and y in metres and the
/// robots' names. Throws files::FileError.
void save_provenance(const team_map::MergedMap& merged, const std::filesystem::path& file);

/// The map of all robots that are joined to a member, in its frame, with its own path. Throws
/// files::FileError.
void save_team_map(fleet_member::FleetMember& member,
                   const session::RobotProfile& profile,
                   const std::filesystem::path& folder,
                   const exports::RunSummary& summary);

}  // namespace echomap::apps
