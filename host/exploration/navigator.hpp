// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/company.hpp"
#include "host/exploration/cost_grid.hpp"
#include "host/exploration/explorer.hpp"
#include "host/exploration/path_follower.hpp"
#include "host/exploration/path_planner.hpp"
#include "host/exploration/travel_field.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exploration {

/// Values without another source are ours, chosen in simulation.
struct NavigatorParams {
  CostGridParams costs;
  PathFollowerParams follower;
  /// Distance to back off after a bump.
  double back_off_m = 0.1;
  /// Assumed width of an obstacle that stopped the robot.
  double obstacle_m = 0.2;
  /// Give up after more motions that failed than this in a row (Navigator::forget_failures).
  std::size_t max_failures = 8;
  /// A metre through where somebody else stands costs so many metres of open floor: as long as one
  /// stop takes, the way round is the dearer one.
  double standing_cost = 10.0;
};

/// Whether something stands in the way of a robot whose motion ended so.
bool is_stopped(const pipeline::Snapshot& snapshot, MotionResult last);

/// Leads a robot over the floor of its map to places that a strategy chooses, and remembers what
/// has stopped it on the way.
class Navigator {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit Navigator(const NavigatorParams& params);

  /// The map of a snapshot with `margin_m` of unknown floor around it, and with what has stopped
  /// the robot.
  mapping::RasterMap map_of(const pipeline::Snapshot& snapshot, double margin_m) const;
  /// Those who stand about from now on. Ways lead round them where that is not too far.
  void set_standing(std::vector<OccupiedFloor> standing) { standing_ = std::move(standing); }
  /// Plans by that map from now on, and prices the ways to all of its places.
  void set_map(const mapping::RasterMap& map, const pipeline::Snapshot& snapshot);
  /// Plans by another map until the next `set_map`, as one with floor that is only supposed.
  void set_hypothetical_map(const mapping::RasterMap& map, const pipeline::Snapshot& snapshot);
  /// As of the last of these two, which has to be before.
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access)
  const CostGrid& costs() const { return *costs_; }
  /// As of the last `set_map`.
  const TravelField& travel() const { return travel_; }

  /// Takes the way to `goal_m`, which costs `cost_m`; none where that is 0.
  void follow_path_to(const geometry::Pose2& T_map_robot,
                      const Eigen::Vector2d& goal_m,
                      double cost_m);
  /// The next motion on the way; empty where it ends, or has taken too long.
  std::optional<Motion> next(const geometry::Pose2& T_map_robot);

  /// After a motion: the way back from what has stopped a robot that is driving, Finished after too
  /// many that failed, or nothing where it may go on.
  std::optional<Motion> recover(const pipeline::Snapshot& snapshot,
                                MotionResult last,
                                bool is_driving);
  /// It has got somewhere, or is about to try something else.
  void forget_failures() { failures_ = 0; }
  const std::vector<Eigen::Vector2d>& obstacles_m() const { return obstacles_m_; }

 private:
  /// Remembers what has stopped the robot, right before the hull or on the side where the bumper is
  /// pushed, and answers how it comes away from there.
  Drive back_off(const pipeline::Snapshot& snapshot);

  NavigatorParams params_;
  PathFollower follower_;
  PathPlanner planner_;
  TravelField travel_;
  std::optional<CostGrid> costs_;
  std::size_t motions_left_ = 0;  ///< That the way may still take.
  std::size_t failures_ = 0;
  std::vector<Eigen::Vector2d> obstacles_m_;
  std::vector<OccupiedFloor> standing_;
};

}  // namespace echomap::exploration
