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

/// What one robot, or somebody who only looks on, makes of what a fleet has told: the maps joined
/// where that is sure, and everything seen from one map.
class TeamPicture {
 public:
  explicit TeamPicture(const team_map::TeamMapParams& params = {}) : team_(params) {}

  /// Takes what is known now. Joins and aligns where a record has changed, which may take a second;
  /// answers whether maps or their relative poses have changed.
  bool take(const fleet::FleetState& state);
  /// The same for somebody who only looks on: maps that robots of the fleet have joined are joined
  /// here, too. A look at what they know now would not be sure of what theirs in a row were.
  bool take_with_joins(const fleet::FleetState& state);
  /// From now on this holds of two maps, whatever walls say.
  void tell(const std::string& own_map,
            const std::string& peer_map,
            const team_map::RelativePose& relative);

  /// The fleet in the frame of a map of `robot`, without that robot. Robots whose maps are not
  /// joined to it are not in it.
  team_exploration::TeamView view(const fleet::FleetState& state,
                                  const std::string& robot,
                                  std::uint16_t map_number);
  /// Where the others of it are now, in that map; takes no time, so that it may be asked often.
  std::vector<team_exploration::Peer> peers(const fleet::FleetState& state,
                                            const std::string& robot,
                                            std::uint16_t map_number) const;
  /// Where that robot's map of now lies in that map; empty where they are not joined.
  std::optional<team_map::RelativePose> relative_pose(const std::string& own_map,
                                                      const fleet::FleetRobot& robot) const;
  /// Where the maps that are joined to that one lie in it, to be told by the robot whose map is the
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
