// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "host/fleet_member/join_log.hpp"
#include "host/team_exploration/avoidance.hpp"

namespace echomap::apps {

/// What meeting others led to, of all explorers that have driven a member in turn.
struct MemberEncounters {
  team_exploration::Encounters counts;
  bool ended_in_deadlock = false;  ///< The last of them waited for one who waited for it.

  /// One of the explorers has ended.
  void add(const team_exploration::Encounters& of_one, bool is_in_deadlock);
};

/// `team` of a member's summary.json: the joins of its map, and its encounters.
nlohmann::ordered_json team_report(const fleet_member::JoinLog& joins,
                                   const MemberEncounters& encounters);

/// What one member of a fleet says of its run.
struct MemberReport {
  std::string robot;
  std::string outcome;  ///< Empty of one that has written nothing.
  double sim_seconds = 0.0;
  std::size_t stops = 0;
  std::vector<fleet_member::LoggedJoin> joins;
  MemberEncounters encounters;
};

/// Reads `run`/summary.json of the member of that name. Throws files::FileError where it is missing
/// or not what a member has written to its end.
MemberReport read_member_report(const std::string& robot, const std::filesystem::path& run);

/// Its outcome, times and encounters as a fleet's report has them.
nlohmann::ordered_json to_json(const MemberReport& member);

}  // namespace echomap::apps
