// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/robot_params.hpp"
#include "host/geometry/pose2.hpp"
#include "host/team_map/submap.hpp"

namespace echomap::tests {

/// What a robot knew when a stop had ended.
struct RecordedStop {
  double end_s = 0.0;
  /// Its pose graph then; as many as it had submaps.
  std::vector<geometry::Pose2> T_map_submaps;
};

/// A robot that explored a world for itself: what it would have told a team, and the truth.
struct TeamRecording {
  team_map::RobotRecord record;  ///< As it was in the end.
  std::vector<RecordedStop> stops;
  geometry::Pose2 T_world_start;
  std::vector<geometry::Pose2> T_world_submaps;  ///< Truth, at the first reading of each.

  /// What the robot has told after so many stops.
  team_map::RobotRecord after(std::size_t stops) const;
  /// Metres between its submaps as placed and as they truly lie, root mean square.
  double error_m(const geometry::Pose2& T_world_map,
                 const std::vector<geometry::Pose2>& T_map_submaps) const;
};

/// Starts of so many robots, drawn: at least `path_m` of way apart from each other.
std::vector<geometry::Pose2> team_starts(const world::FloorPlan& plan,
                                         std::size_t robots,
                                         double path_m,
                                         std::uint32_t seed);

/// Lets a robot explore by `frontier` with SLAM, without firmware.
TeamRecording record_offline(const world::FloorPlan& plan,
                             const world::RobotParams& robot,
                             const geometry::Pose2& T_world_start,
                             std::uint32_t seed,
                             std::size_t max_stops);

/// The robots of a seed in a bundled world, each for itself; what was recorded once is read from
/// `folder`, for exploring takes longer than joining.
std::vector<TeamRecording> team_recordings(const std::string& world,
                                           std::size_t robots,
                                           std::uint32_t seed,
                                           const std::filesystem::path& folder);

}  // namespace echomap::tests
