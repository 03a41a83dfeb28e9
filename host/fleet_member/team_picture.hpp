// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/fleet/fleet_state.hpp"
#include "host/team_exploration/team_view.hpp"
#include "host/team_map/team_map.hpp"

namespace echomap::fleet_member {

/// The name of one map of a robot among all maps of a fleet: "robot0.0".
std::string map_name(const std::string& robot, std::uint16_t number);

/// What one robot, or an observer, derives from what a fleet has published: its maps joined where
/// that is sure, and everything in the frame of one map.
class TeamPicture {
 public:
  explicit TeamPicture(const team_map::TeamMapParams& params = {}) : team_(params) {}

  /// Takes the current state. Joins and aligns where a record has changed, which may take a second.
  /// Returns whether maps or their relative poses have changed.
  bool take(const fleet::FleetState& state);
  /// The same for an observer: maps that robots of the fleet have joined are joined here, too. One
  /// comparison of what they know now would not be as sure as theirs in a row were.
  bool take_with_joins(const fleet::FleetState& state);
  /// Sets the relative pose of two maps, whatever the readings show.
  void set_known_pose(const std::string& own_map,
                      const std::string& peer_map,
                      const team_map::RelativePose& relative);

  /// The fleet in the frame of a map of `robot`, without that robot. Robots whose maps are not
  /// joined to it are not in it.
  team_exploration::TeamView view(const fleet::FleetState& state,
                                  const std::string& robot,
                                  std::uint16_t map_number);
  /// Poses of the others now, in that map. Fast enough to be called often.
  std::vector<team_exploration::Peer> peers(const fleet::FleetState& state,
                                            const std::string& robot,
                                            std::uint16_t map_number) const;
  /// Pose of that robot's current map in `own_map`; empty where they are not joined.
  std::optional<team_map::RelativePose> relative_pose(const std::string& own_map,
                                                      const fleet::FleetRobot& robot) const;
  /// Poses of the maps that are joined to that one, to be published by the robot whose map is the
  /// first of them; empty for the others, and where nothing is joined.
  std::vector<fleet_messages::AlignedMap> alignment(const std::string& robot,
                                                    std::uint16_t map_number) const;
  team_map::TeamMap& team() { return team_; }
  const team_map::TeamMap& team() const { return team_; }

 private:
  team_map::TeamMap team_;
  std::optional<std::uint64_t> revision_;
};

}  // namespace echomap::fleet_member
