// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "hil_mock/world/polygon.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::world {

/// What a wall does to sound: a smooth one is a mirror, a rough one scatters.
enum class Material : std::uint8_t { kSmooth, kRough };

/// A closed outline and what its sides are made of.
struct Outline {
  Polygon corners_m;
  /// Of the side from each corner to the next; where it is shorter, the rest is smooth.
  std::vector<Material> materials;
};

/// One side of an outline; free space lies to its left.
struct Wall {
  Segment segment;
  Material material = Material::kSmooth;
};

/// Where two walls meet.
struct Corner {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  /// Turn from wall to wall: positive for a niche (the corner of a room), negative for an edge
  /// that stands into the free space.
  double turn_rad = 0.0;
};

/// A room seen from above, in metres in the world frame: an outline and what stands in it.
class FloorPlan {
 public:
  /// Throws std::invalid_argument where an outline crosses itself, an obstacle is not inside of
  /// the room or the start is not free.
  FloorPlan(std::string name,
            Outline room,
            std::vector<Outline> obstacles,
            const geometry::Pose2& T_world_start);

  const std::string& name() const { return name_; }
  const Polygon& room_m() const { return room_m_; }
  const std::vector<Polygon>& obstacles_m() const { return obstacles_m_; }
  const std::vector<Wall>& walls() const { return walls_; }
  const std::vector<Corner>& corners() const { return corners_; }
  const geometry::Pose2& T_world_start() const { return T_world_start_; }

  /// Whether a point is inside of the room and outside of every obstacle.
  bool is_free(const Eigen::Vector2d& point_m) const;
  /// Distance from a point to the nearest wall.
  double clearance_m(const Eigen::Vector2d& point_m) const;
  /// The same room with another start; throws std::invalid_argument where it is not free.
  FloorPlan starting_at(const geometry::Pose2& T_world_start) const;

 private:
  void add_walls(Outline outline, bool counter_clockwise);

  std::string name_;
  Polygon room_m_;
  std::vector<Polygon> obstacles_m_;
  std::vector<Wall> walls_;
  std::vector<Corner> corners_;
  geometry::Pose2 T_world_start_;
};

}  // namespace echomap::world
