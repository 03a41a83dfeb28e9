// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/team_map/team_map.hpp"

namespace echomap::fleet_member {

/// Another map, while it was joined to a robot's own.
struct LoggedJoin {
  std::string own_map;  ///< Names as by map_name().
  std::string peer_map;
  double from_s = 0.0;
  std::optional<double>
      until_s;                 ///< When it was undone, or another own map begun; empty: it holds.
  geometry::Pose2 T_own_peer;  ///< As it was when they were joined.
};

/// What maps a robot's own was joined with, and when: what a run's report says of it.
class JoinLog {
 public:
  /// Takes how it is at this time, which is no earlier than the last one.
  void look(double now_s, const std::string& own_map, const team_map::TeamMap& team);
  const std::vector<LoggedJoin>& joins() const { return joins_; }

 private:
  std::vector<LoggedJoin> joins_;
};

}  // namespace echomap::fleet_member
