// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/travel_field.hpp"
#include "host/exploration/view_gain.hpp"
#include "host/geometry/segment.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/mapping/wall_completion.hpp"

namespace echomap::exploration {

/// Which stretches of wall may be doors. Ours, chosen in simulated rooms.
struct PossibleDoorParams {
  /// Narrower ones no robot is sent through.
  double min_width_m = 0.5;
  /// A stop tells a wall from the frame of a door where the nearer end is at least so much farther
  /// off than the foot of the perpendicular (mapping::end_excess_m).
  double told_apart_m = mapping::WallCompletionParams{}.told_apart_m;
  /// It is looked at from before its middle, time after time from the next of these shares of the
  /// distance from which a stop can tell, which is at most so far.
  std::vector<double> stand_shares{0.9, 0.7, 0.5};
  double max_distance_m = 1.2;
  /// Middles that are nearer to each other are of the same door: the map moves.
  double apart_m = 0.3;
};

/// Of the stretches of wall that no stop has heard at right angles, and gaps in walls, the floor to
/// the left of each, those that may be doors for all that the views have told: what lies behind
/// them is unknown.
std::vector<geometry::Segment> possible_doors(const mapping::RasterMap& map,
                                              const std::vector<geometry::Segment>& unheard,
                                              const std::vector<PastView>& views,
                                              const PossibleDoorParams& params);

/// A place from which a look can tell what it is, and what the way there costs.
struct DoorStand {
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();  ///< Of the door.
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double cost_m = 0.0;
};

/// The nearest by its way; empty where each that can be reached was tried as often as there are
/// shares. `tried_m` has the middle of a door for each time.
std::optional<DoorStand> nearest_door_stand(const mapping::RasterMap& map,
                                            const std::vector<geometry::Segment>& doors,
                                            const TravelField& travel,
                                            const std::vector<Eigen::Vector2d>& tried_m,
                                            const PossibleDoorParams& params);

}  // namespace echomap::exploration
