// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/fleet/fleet_state.hpp"
#include "host/fleet_member/team_picture.hpp"
#include "host/source_search/field_model.hpp"
#include "host/source_search/information_gain.hpp"

namespace echomap::fleet_member {

/// The sure result of a robot that searches a source.
struct TeamFinding {
  std::string robot;  ///< Robot that has published it.
  fleet_messages::SearchReport report;
  /// Position of the source in the requested map; empty where there is none, or where the robot's
  /// map is not joined to that one.
  std::optional<Eigen::Vector2d> at_m;
};

/// A reading of another robot, with what identifies it in the fleet.
struct SharedReading {
  std::string map;  ///< The robot's map, as map_name() calls it.
  double stamp_s = 0.0;
  source_search::FieldReading reading;  ///< In the requested map.
};

/// What other robots that search a source have published, in the frame of one robot's map.
struct SearchView {
  std::vector<SharedReading> readings;             ///< By map, then in the order of time.
  std::vector<source_search::PlannedDwell> plans;  ///< What they are about to read.
  std::optional<TeamFinding> finding;              ///< Of the first robot by name that has one.
};

/// Search view of all robots except `without`, in the frame of `map`. Readings and plans are those
/// of robots whose maps are joined to it; findings are those of any robot. `place_stddev_m` is the
/// standard deviation of a reading's place in its own robot's map, along each axis; that of the
/// relative pose of the maps is added.
SearchView search_view(const fleet::FleetState& state,
                       const TeamPicture& picture,
                       const std::string& map,
                       const std::string& without,
                       double place_stddev_m);

}  // namespace echomap::fleet_member
