// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "hil_mock/world/person.hpp"
#include "hil_mock/world/source_field.hpp"
#include "host/geometry/polygon.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::world {

/// The corners of a room or an object, in metres of the world.
using geometry::Polygon;
using geometry::Segment;

/// What a wall does to sound and light: a smooth one is a mirror for sound, a rough one scatters
/// it, and glass is a mirror for both, so that it is seen only straight on.
enum class Material : std::uint8_t { kSmooth, kRough, kGlass };

/// "smooth", "rough" or "glass".
std::string_view name_of(Material material);

/// What a wall is made of.
struct Surface {
  Material material = Material::kSmooth;
  /// Share of infra-red light that it throws back: 0.9 of white paint, Sharp's test card too.
  double reflectance = 0.9;
};

/// A closed outline and what its sides are made of.
struct Outline {
  Polygon corners_m;
  /// Of the side from each corner to the next; where it is shorter, the rest is as by default.
  std::vector<Surface> surfaces;
  /// What a metre of the solid takes of gamma rays, as a factor exp(-attenuation): of the obstacle
  /// inside, or of all that is outside of the room.
  double attenuation_per_m = kConcretePerM;
};

/// One side of an outline; free space lies to its left.
struct Wall {
  Segment segment;
  Surface surface;
};

/// Where two walls meet.
struct Corner {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  /// Turn from wall to wall: positive for a niche (the corner of a room), negative for an edge
  /// that stands into the free space.
  double turn_rad = 0.0;
};

/// A beam of infra-red light that a robot is to take for a wall (the Create's "virtual wall").
struct VirtualWall {
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
  double length_m = 0.0;
  /// Half of the beam's opening.
  double beam_half_angle_rad = 0.0;
};

/// What a floor has that is no wall, who crosses it, and what radiates.
struct FloorMarks {
  /// Where there is no floor: stairs, the edge of a table.
  std::vector<Polygon> holes_m;
  std::vector<VirtualWall> virtual_walls;
  std::vector<PersonParams> people = {};
  std::vector<Source> sources = {};
  Backgrounds backgrounds = {};
};

/// A room seen from above, in metres in the world frame: an outline, what stands in it and what is
/// on its floor.
class FloorPlan {
 public:
  /// Throws std::invalid_argument where an outline crosses itself, an obstacle, a hole or a source
  /// is not inside of the room or the start is not free.
  FloorPlan(std::string name,
            Outline room,
            std::vector<Outline> obstacles,
            const geometry::Pose2& T_world_start,
            FloorMarks marks = {});

  const std::string& name() const { return name_; }
  const Polygon& room_m() const { return room_m_; }
  const std::vector<Polygon>& obstacles_m() const { return obstacles_m_; }
  /// All that stands at this moment: what stands always, and behind it the sides of people and of
  /// other robots.
  const std::vector<Wall>& walls() const { return walls_; }
  /// What stands always.
  std::span<const Wall> still_walls() const { return std::span(walls_).first(still_walls_); }
  const std::vector<Corner>& corners() const { return corners_; }
  const std::vector<Polygon>& holes_m() const { return marks_.holes_m; }
  const std::vector<VirtualWall>& virtual_walls() const { return marks_.virtual_walls; }
  const std::vector<PersonParams>& people() const { return marks_.people; }
  const std::vector<Source>& sources() const { return marks_.sources; }
  const Backgrounds& backgrounds() const { return marks_.backgrounds; }
  /// What attenuates gamma rays outside of the room, and inside of each of `obstacles_m`.
  double room_attenuation_per_m() const { return room_attenuation_per_m_; }
  const std::vector<double>& attenuations_per_m() const { return attenuations_per_m_; }
  const geometry::Pose2& T_world_start() const { return T_world_start_; }

  /// Whether a point is inside of the room and outside of every obstacle and hole.
  bool is_free(const Eigen::Vector2d& point_m) const;
  /// Whether there is no floor under a point.
  bool is_hole(const Eigen::Vector2d& point_m) const;
  /// Distance from a point to the nearest wall that stands always.
  double clearance_m(const Eigen::Vector2d& point_m) const;
  /// The same room with another start; throws std::invalid_argument where it is not free.
  FloorPlan starting_at(const geometry::Pose2& T_world_start) const;
  /// The same room with other sources of radiation, and those of other kinds; throws
  /// std::invalid_argument for one that is not inside of the room.
  FloorPlan with_radiation(const std::vector<Source>& sources) const;

  /// From now on a box stands there, upright; what of it is in a wall or an obstacle does not show.
  void put_box(Outline box);
  /// Those, oldest first.
  std::span<const Polygon> boxes_m() const { return std::span(obstacles_m_).subspan(furniture_); }
  /// What has stood from the beginning.
  std::span<const Wall> first_walls() const { return std::span(walls_).first(first_walls_); }

  /// Puts people where they are now, in place of those before.
  void put_people(std::span<const Disc> people);
  /// The same for robots: round hulls that scatter sound.
  void put_robots(std::span<const Disc> robots);
  const std::vector<Disc>& robots() const { return robots_; }
  /// What `walls` has but for the sides of robots, whose hulls are as round as `robots` says.
  std::span<const Wall> walls_besides_robots() const;

 private:
  void add_walls(Outline outline, bool counter_clockwise);
  void check_holes() const;
  void check_sources() const;
  void add_sides(const Disc& disc, const Surface& surface);
  void draw_movers();

  std::string name_;
  Polygon room_m_;
  std::vector<Polygon> obstacles_m_;  ///< The first `furniture_` are no boxes.
  std::size_t furniture_ = 0;
  double room_attenuation_per_m_;
  std::vector<double> attenuations_per_m_;  ///< Of each obstacle.
  FloorMarks marks_;
  std::vector<Wall> walls_;  ///< The first `still_walls_` stand always.
  std::size_t still_walls_ = 0;
  std::size_t first_walls_ = 0;
  std::vector<Corner> corners_;
  std::vector<Disc> people_;
  std::vector<Disc> robots_;
  geometry::Pose2 T_world_start_;
};

}  // namespace echomap::world
