// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/apps/member_report.hpp"
#include "host/evaluation/trajectory_error.hpp"
#include "host/geometry/pose2.hpp"
#include "host/team_map/submap.hpp"

namespace echomap::apps {

/// One map of a member of a fleet, scored against the truth.
struct ScoredMap {
  std::string name;
  /// The placement that brings all its stops nearest to where they truly were
  /// (evaluation::fit_aligned),
  geometry::Pose2 T_world_map;
  double own_error_m = 0.0;  ///< and how far they are off even so, root mean square.
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();  ///< Of its stops, in its own frame,
  Eigen::Vector2d last_m = Eigen::Vector2d::Zero();    ///< and the last of them.
  std::vector<double> stop_s;                          ///< When each stop ended.
  /// After each stop, which cells of the floor in reach it called free.
  std::vector<std::vector<bool>> seen;
};

/// Scores a map: where it truly lies, and when it had which of the floor `floor_m`, given by the
/// centres of its cells in the world frame. Poses of its graph are those of the end. Empty without
/// a stop, or where the truth knows none of them.
std::optional<ScoredMap> score_map(const team_map::RobotRecord& record,
                                   const std::vector<evaluation::TruePose>& truth,
                                   const std::vector<Eigen::Vector2d>& floor_m);

/// How far a place of one map in another is from the true one: of the peer's last stop, and of its
/// heading without a sign. No placement can be better than the two maps are by themselves.
struct RelativePoseError {
  double position_m = 0.0;
  double heading_rad = 0.0;
  double own_errors_m = 0.0;  ///< ScoredMap::own_error_m of both, added up.
};

/// That of `T_own_peer`.
RelativePoseError relative_pose_error(const geometry::Pose2& T_own_peer,
                                      const ScoredMap& own,
                                      const ScoredMap& peer);

/// The map of that name; null where there is none.
const ScoredMap* find_map(const std::vector<ScoredMap>& maps, const std::string& name);

/// How a fleet came to one map.
struct FleetCourse {
  /// From when on the first member's last map was joined with the last map of each other member;
  /// empty where it was not at the end.
  std::optional<double> joined_s;
  /// Joins, each as each member had it, that placed a map more than half a metre or 20 degrees off.
  std::size_t wrong_joins = 0;
  std::size_t wrong_joins_left = 0;  ///< Those that were never undone.
  /// When the maps that were one then had nine tenths of the floor in reach for some member.
  std::optional<double> floor_90_s;
  double floor_seen = 0.0;  ///< Share of it at the end, for the member that has most.
};

/// Scores how a fleet came to one map. `maps` are those of all members, those of one in the order
/// in which it made them.
FleetCourse score_course(const std::vector<ScoredMap>& maps,
                         const std::vector<MemberReport>& members);

}  // namespace echomap::apps
