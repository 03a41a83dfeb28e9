// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/placeable_map.hpp"
#include "host/mapping/sonar_mapper.hpp"
#include "host/mapping/sonar_surfaces.hpp"
#include "host/mapping/surface_matching.hpp"
#include "host/slam/stop_heading.hpp"
#include "host/team_map/calibrated_submaps.hpp"
#include "host/team_map/placed_submaps.hpp"
#include "host/team_map/submap.hpp"

namespace echomap::team_map {

/// The map of one robot alone, in its own map frame, built from what it has published.
class RobotMap {
 public:
  /// `params` are those of the team; the beam is the robot's.
  explicit RobotMap(const mapping::SonarMapperParams& params) : params_(params) {}

  /// Takes all that the robot has published so far. Returns whether anything is new.
  bool take(RobotRecord record);

  const std::string& robot() const { return record_.robot; }
  /// Submaps with calibrated turns.
  const std::vector<Submap>& submaps() const { return calibrated_.submaps(); }
  const std::vector<geometry::Pose2>& T_map_submaps() const { return record_.T_map_submaps; }
  double beam_half_angle_rad() const { return record_.beam_half_angle_rad; }
  double body_radius_m() const { return record_.body_radius_m; }
  const PlacedSubmaps& placed() const { return placed_; }
  /// The robot's map as cells. This and the functions below need at least one submap.
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): take() has set it
  const mapping::PlaceableMap& map() const { return *map_; }
  /// Surfaces that each submap has measured, in the frame of its first reading.
  const std::vector<mapping::ScanSurfaces>& surfaces() const { return surfaces_; }
  /// The same surfaces on the map.
  const std::vector<mapping::ScanSurfaces>& placed_surfaces() const { return placed_surfaces_; }
  /// Walls and posts found in all submaps together.
  const mapping::MatchedSurfaces& features() const { return features_; }
  /// Predicts what a sonar measures of those features.
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): take() has set it
  const slam::SonarScene& scene() const { return *scene_; }
  /// Log-likelihood of each reading of each submap, given what the robot's other submaps have
  /// measured: as well as this map explains any reading.
  const std::vector<std::vector<double>>& own_log_likelihoods() const { return own_; }

 private:
  void find_features();

  mapping::SonarMapperParams params_;
  RobotRecord record_;
  CalibratedSubmaps calibrated_;
  PlacedSubmaps placed_;
  std::optional<mapping::SonarMapper> mapper_;
  std::optional<mapping::PlaceableMap> map_;
  std::vector<mapping::ScanSurfaces> surfaces_;
  std::vector<mapping::ScanSurfaces> placed_surfaces_;
  mapping::MatchedSurfaces features_;
  std::optional<slam::SonarScene> scene_;
  std::vector<std::vector<double>> own_;
};

}  // namespace echomap::team_map
