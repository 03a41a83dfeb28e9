// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/bump_insertion.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/ray_insertion.hpp"

namespace echomap::mapping {

/// What a robot knows of the floor next to it, and how much each of it says. Evidence is in
/// hundredths of log-odds; the values are ours, chosen in simulated rooms.
struct NearMapperParams {
  /// From the middle of the axle to the hull, metres; 0 for a body that is not known, whose floor
  /// and bumps say nothing.
  double body_radius_m = 0.0;
  /// For a cell that the body stands on; it is told again after `body_step_m`.
  int body_centilogits = -100;
  double body_step_m = 0.01;
  BumpParams bump;
  /// Where a switch that closes alone has met something: halfway between straight ahead, where both
  /// close, and the end of a bumper of 70 to 80 degrees.
  double one_sided_bump_rad = 0.7;
  /// The infra-red sensors in the order of their readings, and how far they see.
  std::vector<geometry::Pose2> T_robot_infrared;
  double infrared_reach_m = 0.0;
  /// Of a wall that answers, and of the floor before it.
  RayInsertionParams infrared = {85, -20};
  /// Of the floor before a sensor that nothing answers. A wall at a slant is silent, too (Mahmood
  /// and Ridao 2017, section 4), so that this says little.
  int silent_centilogits = -10;
  /// A sensor that looks within this angle of another one with a shorter range sees the same wall
  /// at a slant, and its weak answer seems to come from behind it: it tells of no wall.
  double same_wall_rad = 1.2;
};

/// Makes a grid of what a robot feels: walls in reach of infra-red sensors of a few centimetres,
/// what its bumpers have met, and the floor that its body has been on. In the map frame, by the
/// poses of their time.
class NearMapper {
 public:
  /// Throws std::invalid_argument for parameters without sense.
  NearMapper(const NearMapperParams& params, const OccupancyGridParams& grid);

  /// The body is here.
  void pass_over(const geometry::Pose2& T_map_robot);
  /// A switch has closed, or both.
  void bump(const geometry::Pose2& T_map_robot, bool left, bool right);
  /// One round of the infra-red sensors; empty where nothing is in reach.
  void see(const geometry::Pose2& T_map_robot, std::span<const std::optional<double>> range_m);

  const OccupancyGrid& grid() const { return grid_; }

 private:
  bool sees_a_slanted_wall(std::span<const std::optional<double>> range_m, std::size_t i) const;

  NearMapperParams params_;
  OccupancyGrid grid_;
  RayInserter answers_;
  RayInserter silence_;
  std::optional<Eigen::Vector2d> last_stand_m_;
};

/// What is known from afar and from near: where near evidence has fallen, that from afar counts no
/// more than `most_centilogits`, so that a bump makes a wall and a body floor whatever an echo has
/// said. Both grids have one resolution.
OccupancyGrid with_near_evidence(OccupancyGrid far,
                                 const OccupancyGrid& near,
                                 int most_centilogits = 200);

}  // namespace echomap::mapping
