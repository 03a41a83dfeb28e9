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

/// What a robot that searches a source is sure of.
struct TeamFinding {
  std::string robot;  ///< The one that says so.
  fleet_messages::SearchReport report;
  /// Where the source is in the map that is asked for; empty where there is none, or where the
  /// robot's map is not joined to that one.
  std::optional<Eigen::Vector2d> at_m;
};

/// A reading of another robot, and which one it is among all of the fleet's.
struct SharedReading {
  std::string map;  ///< The robot's map, as map_name() calls it.
  double stamp_s = 0.0;
  source_search::FieldReading reading;  ///< In the map that is asked for.
};

/// What others who search a source have told, in the frame of one robot's map.
struct SearchView {
  std::vector<SharedReading> readings;             ///< By map, then in the order of time.
  std::vector<source_search::PlannedDwell> plans;  ///< What they are about to read.
  std::optional<TeamFinding> finding;              ///< Of the first of them by name that has one.
};

/// Of all robots but `without`, in the frame of the map of that name. Readings and plans are those
/// of robots whose maps are joined to that one; findings are anybody's. `place_stddev_m` is that of
/// a reading in its own robot's map, along each axis; how well the maps lie to each other comes on
/// top.
SearchView search_view(const fleet::FleetState& state,
                       const TeamPicture& picture,
                       const std::string& map,
                       const std::string& without,
                       double place_stddev_m);

}  // namespace echomap::fleet_member
