// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/team_map/team_map.hpp"

namespace echomap::fleet_member {

/// A join of another map to a robot's own.
struct LoggedJoin {
  std::string own_map;  ///< Names as by map_name().
  std::string peer_map;
  double from_s = 0.0;
  /// When it was undone, or another own map was begun; empty while it holds.
  std::optional<double> until_s;
  geometry::Pose2 T_own_peer;  ///< As it was when they were joined.
};

/// The maps that a robot's own was joined with, and when, for the report of a run.
class JoinLog {
 public:
  /// Records the joins at this time, which is no earlier than the last one.
  void look(double now_s, const std::string& own_map, const team_map::TeamMap& team);
  const std::vector<LoggedJoin>& joins() const { return joins_; }

 private:
  std::vector<LoggedJoin> joins_;
};

}  // namespace echomap::fleet_member
