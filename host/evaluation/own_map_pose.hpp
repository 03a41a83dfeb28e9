// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/evaluation/trajectory_error.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/pose2.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::evaluation {

/// A place within both of the true one is the right one: ours.
inline constexpr double kRightPlaceM = 0.30;
inline constexpr double kRightPlaceRad = geometry::radians(20.0);

/// Where a map that a robot has made has a true pose: T_map_pose of T_world_pose.
///
/// Such a map is a little bent, so that no one placement in the world fits all of it. What counts
/// is what is around the pose, and the robot mapped that when it was near. `explored` is how the
/// map has the exploration at its end (T_map_robot), `truth` how it was; of its instants that the
/// truth covers, the one at which the robot truly was nearest places the map:
/// T_map_robot(t) * T_world_robot(t)^-1 * T_world_pose.
///
/// Where the robot has never been within 1.5 m, as far as a sonar maps well, no instant speaks for
/// what is there, and the first pose places the map, as in `start_aligned`. Throws
/// std::invalid_argument where the truth covers none.
geometry::Pose2 own_map_pose(const std::vector<pipeline::StampedPose>& explored,
                             const std::vector<TruePose>& truth,
                             const geometry::Pose2& T_world_pose);

/// How far an estimated pose is off the true one, in the map that it is an estimate in.
struct PlaceError {
  double error_m = 0.0;
  double heading_error_rad = 0.0;  ///< Of 0 to pi.

  bool is_right() const { return error_m <= kRightPlaceM && heading_error_rad <= kRightPlaceRad; }
};

/// That of an estimate in the map of `explored` (`own_map_pose`); empty where the truth does not
/// cover its stamp. Throws as `own_map_pose` does.
std::optional<PlaceError> own_map_error(const std::vector<pipeline::StampedPose>& explored,
                                        const std::vector<TruePose>& truth,
                                        const pipeline::StampedPose& estimate);

}  // namespace echomap::evaluation
