// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/segment.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exploration {

/// What is expected behind a stretch of wall that nobody has heard. Ours, chosen in simulated
/// rooms.
struct UnobservedWallParams {
  /// Probability that there is floor in place of one that is at least as long as a door is wide.
  double floor_chance = 0.3;
  /// Width of a narrow door.
  double door_m = 0.5;
  /// Shorter ones do not count: hardly a robot fits through. From here to a door the probability
  /// rises linearly.
  double min_length_m = 0.2;
  /// A stop faces a wall where the foot of its perpendicular is at least so far from both ends.
  double inside_m = 0.1;
  /// And where it is not farther off than this, which is within the sonar's range.
  double max_distance_m = 2.5;
};

/// A stretch of wall that is on the map because wall was heard to both sides of it, or beside a
/// corner (mapping::SonarFeatures::unobserved).
struct UnobservedWall {
  geometry::Segment wall;  ///< The floor is to the left.
  double floor_m2 = 0.0;   ///< Expected behind it.
};

/// On the floor before the middle of it, so far off.
Eigen::Vector2d before_m(const UnobservedWall& unobserved, double distance_m);

/// Those that are long enough, as floor of `depth_m` behind each.
std::vector<UnobservedWall> unobserved_walls(const std::vector<geometry::Segment>& walls,
                                             double depth_m,
                                             const UnobservedWallParams& params);

/// The bearing at which a wall would answer a stop there: that of the foot of the perpendicular.
/// Empty where the stop does not face it, or something occupied stands between.
std::optional<double> facing_rad(const mapping::RasterMap& map,
                                 const Eigen::Vector2d& from_m,
                                 const geometry::Segment& wall,
                                 const UnobservedWallParams& params);

}  // namespace echomap::exploration
