// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/placeable_map.hpp"
#include "host/mapping/sonar_mapper.hpp"
#include "host/team_map/placed_submaps.hpp"
#include "host/team_map/submap.hpp"

namespace echomap::team_map {

/// The map of one robot alone, in its own map frame, made of what it has told.
class RobotMap {
 public:
  /// `params` are those of the team; the beam is the robot's.
  explicit RobotMap(const mapping::SonarMapperParams& params) : params_(params) {}

  /// Takes all that the robot has told so far. Answers whether anything is new.
  bool take(RobotRecord record);

  const std::string& robot() const { return record_.robot; }
  /// With calibrated turns; at least one.
  const std::vector<Submap>& submaps() const { return calibrated_; }
  const std::vector<geometry::Pose2>& T_map_submaps() const { return record_.T_map_submaps; }
  double beam_half_angle_rad() const { return record_.beam_half_angle_rad; }
  double body_radius_m() const { return record_.body_radius_m; }
  const PlacedSubmaps& placed() const { return placed_; }
  /// There must be a submap.
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): take() has set it
  const mapping::PlaceableMap& map() const { return *map_; }

 private:
  mapping::SonarMapperParams params_;
  RobotRecord record_;
  std::vector<Submap> calibrated_;
  PlacedSubmaps placed_;
  std::optional<mapping::SonarMapper> mapper_;
  std::optional<mapping::PlaceableMap> map_;
};

}  // namespace echomap::team_map
