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

/// Settings of a ContactMapper. Evidence is in hundredths of log-odds; values are ours, chosen in
/// simulated rooms.
struct ContactMapperParams {
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
  /// Evidence of an echoing wall, and of the floor in front of it.
  RayInsertionParams infrared = {85, -20};
  /// Evidence of the floor in front of a sensor without a return; small, because a wall at oblique
  /// incidence is silent too (Mahmood and Ridao 2017, section 4).
  int silent_centilogits = -10;
  /// A sensor that looks within this angle of another one with a shorter range sees the same wall
  /// at a slant, and its weak answer seems to come from behind it: it tells of no wall.
  double same_wall_rad = 1.2;
};

/// Maps contacts and short ranges: walls within the few centimetres of infra-red sensors, bumps,
/// and the floor under the body. In the map frame, by the pose at the time of each.
class ContactMapper {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  ContactMapper(const ContactMapperParams& params, const OccupancyGridParams& grid);

  /// Marks the floor under the body at this pose as free.
  void pass_over(const geometry::Pose2& T_map_robot);
  /// Adds a bump: one switch closed, or both. `bumper_radius_m` is the body's where it is 0.
  void bump(const geometry::Pose2& T_map_robot,
            bool left,
            bool right,
            double bumper_radius_m = 0.0);
  /// Adds one reading of each infra-red sensor; empty where nothing is in reach.
  void add_ranges(const geometry::Pose2& T_map_robot,
                  std::span<const std::optional<double>> range_m);

  const OccupancyGrid& grid() const { return grid_; }

 private:
  bool sees_an_oblique_wall(std::span<const std::optional<double>> range_m, std::size_t i) const;

  ContactMapperParams params_;
  OccupancyGrid grid_;
  RayInserter answers_;
  RayInserter silence_;
  std::optional<Eigen::Vector2d> last_stand_m_;
};

/// Fuses the sonar grid and the contact grid: where there is contact evidence, sonar evidence
/// counts at most `max_centilogits`, so that a bump makes a wall and the body makes floor whatever
/// an echo said. Both grids have the same resolution.
OccupancyGrid with_contact_evidence(OccupancyGrid far,
                                    const OccupancyGrid& near,
                                    int max_centilogits = 200);

}  // namespace echomap::mapping
