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
struct UnheardWallParams {
  /// There is floor in place of it with this chance,
  double floor_chance = 0.3;
  /// if it is as long as this: through less a sonar seldom hears what is behind.
  double min_length_m = 0.5;
  /// A stop faces a wall where the foot of its perpendicular is so far from the ends of the
  /// stretch, and it is not farther off than that.
  double inside_m = 0.1;
  double max_distance_m = 2.5;
};

/// A stretch of wall that is on the map because wall was heard to both sides of it, or beside a
/// corner (mapping::SonarFeatures::unheard).
struct UnheardWall {
  geometry::Segment wall;  ///< The floor is to the left.
  double floor_m2 = 0.0;   ///< Expected behind it.
};

/// On the floor before the middle of it.
Eigen::Vector2d before_m(const UnheardWall& unheard);

/// Those that are long enough, as floor of `depth_m` behind each.
std::vector<UnheardWall> unheard_walls(const std::vector<geometry::Segment>& walls,
                                       double depth_m,
                                       const UnheardWallParams& params);

/// The bearing at which a wall would answer a stop there: that of the foot of the perpendicular.
/// Empty where the stop does not face it, or something occupied stands between.
std::optional<double> facing_rad(const mapping::RasterMap& map,
                                 const Eigen::Vector2d& from_m,
                                 const geometry::Segment& wall,
                                 const UnheardWallParams& params);

}  // namespace echomap::exploration
