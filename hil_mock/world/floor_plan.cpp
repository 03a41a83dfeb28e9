// SPDX-License-Identifier: MIT
#include "hil_mock/world/floor_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "host/geometry/unit_vector.hpp"

namespace echomap::world {
namespace {

void check_outline(const Outline& outline, const std::string& what) {
  if (const auto fault = geometry::polygon_fault(outline.corners_m)) {
    throw std::invalid_argument(what + ": " + *fault);
  }
}

/// Runs the outline the other way round; every side keeps its surface.
void reverse(Outline& outline) {
  std::reverse(outline.corners_m.begin(), outline.corners_m.end());
  std::reverse(outline.surfaces.begin(), outline.surfaces.end());
  std::rotate(outline.surfaces.begin(), outline.surfaces.begin() + 1, outline.surfaces.end());
}

double turn_at(const Segment& before, const Segment& after) {
  const Eigen::Vector2d from = before.to_m - before.from_m;
  const Eigen::Vector2d to = after.to_m - after.from_m;
  return std::atan2(geometry::cross(from, to), from.dot(to));
}

/// Trousers scatter sound and are dark.
constexpr Surface kClothes{Material::kRough, 0.4};
/// Boards, wires and wheels scatter sound; how bright they are is assumed.
constexpr Surface kHull{Material::kRough, 0.5};
/// Sides of the polygon that stands for a person or a robot.
constexpr std::size_t kDiscSides = 12;

/// From the middle to the corners of a disc of 1 m, the first again at the end.
const std::array<Eigen::Vector2d, kDiscSides + 1>& disc_corners() {
  static const auto corners = [] {
    std::array<Eigen::Vector2d, kDiscSides + 1> made;
    for (std::size_t i = 0; i < made.size(); ++i) {
      made.at(i) = geometry::unit_vector(-2.0 * std::numbers::pi * static_cast<double>(i) /
                                         static_cast<double>(kDiscSides));
    }
    return made;
  }();
  return corners;
}

}  // namespace

std::string_view name_of(Material material) {
  switch (material) {
    case Material::kRough:
      return "rough";
    case Material::kGlass:
      return "glass";
    case Material::kSmooth:
      break;
  }
  return "smooth";
}

FloorPlan::FloorPlan(std::string name,
                     Outline room,
                     std::vector<Outline> obstacles,
                     const geometry::Pose2& T_world_start,
                     FloorMarks marks)
    : name_(std::move(name)),
      room_m_(room.corners_m),
      room_attenuation_per_m_(room.attenuation_per_m),
      marks_(std::move(marks)),
      T_world_start_(T_world_start) {
  check_outline(room, "room");
  add_walls(std::move(room), true);
  for (Outline& obstacle : obstacles) {
    check_outline(obstacle, "obstacle");
    if (!geometry::contains(room_m_, obstacle.corners_m)) {
      throw std::invalid_argument("obstacle: it is not inside of the room");
    }
    obstacles_m_.push_back(obstacle.corners_m);
    attenuations_per_m_.push_back(obstacle.attenuation_per_m);
    add_walls(std::move(obstacle), false);
  }
  still_walls_ = first_walls_ = walls_.size();
  furniture_ = obstacles_m_.size();
  check_holes();
  check_sources();
  if (!is_free(T_world_start.position_m())) {
    throw std::invalid_argument("start: it is not in the free space of the room");
  }
}

void FloorPlan::add_walls(Outline outline, bool counter_clockwise) {
  const std::size_t count = outline.corners_m.size();
  outline.surfaces.resize(count);
  if ((geometry::signed_area_m2(outline.corners_m) > 0.0) != counter_clockwise) {
    reverse(outline);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Segment here = geometry::side(outline.corners_m, i);
    walls_.push_back({here, outline.surfaces[i]});
    corners_.push_back(
        {here.to_m, turn_at(here, geometry::side(outline.corners_m, (i + 1) % count))});
  }
}

void FloorPlan::check_holes() const {
  for (const Polygon& hole_m : marks_.holes_m) {
    if (const auto fault = geometry::polygon_fault(hole_m)) {
      throw std::invalid_argument("hole: " + *fault);
    }
    if (!geometry::contains(room_m_, hole_m)) {
      throw std::invalid_argument("hole: it is not inside of the room");
    }
  }
}

void FloorPlan::check_sources() const {
  for (const Source& source : marks_.sources) {
    if (!geometry::contains(room_m_, source.position_m)) {
      throw std::invalid_argument("source: it is not inside of the room");
    }
  }
}

bool FloorPlan::is_free(const Eigen::Vector2d& point_m) const {
  const auto holds_point = [&](const Polygon& obstacle) {
    return geometry::contains(obstacle, point_m) ||
           geometry::distance_to_sides_m(obstacle, point_m) == 0.0;
  };
  return geometry::contains(room_m_, point_m) && !is_hole(point_m) &&
         std::none_of(obstacles_m_.begin(), obstacles_m_.end(), holds_point);
}

bool FloorPlan::is_hole(const Eigen::Vector2d& point_m) const {
  return std::any_of(marks_.holes_m.begin(), marks_.holes_m.end(), [&](const Polygon& hole_m) {
    return geometry::contains(hole_m, point_m);
  });
}

double FloorPlan::clearance_m(const Eigen::Vector2d& point_m) const {
  double min_m = std::numeric_limits<double>::infinity();
  for (const Wall& wall : still_walls()) {
    min_m = std::min(min_m, (nearest_point(wall.segment, point_m) - point_m).norm());
  }
  return min_m;
}

void FloorPlan::put_box(Outline box) {
  check_outline(box, "box");
  walls_.resize(still_walls_);
  obstacles_m_.push_back(box.corners_m);
  attenuations_per_m_.push_back(box.attenuation_per_m);
  add_walls(std::move(box), false);
  still_walls_ = walls_.size();
  draw_movers();
}

void FloorPlan::put_people(std::span<const Disc> people) {
  people_.assign(people.begin(), people.end());
  draw_movers();
}

void FloorPlan::put_robots(std::span<const Disc> robots) {
  robots_.assign(robots.begin(), robots.end());
  draw_movers();
}

std::span<const Wall> FloorPlan::walls_besides_robots() const {
  return std::span(walls_).first(walls_.size() - kDiscSides * robots_.size());
}

void FloorPlan::draw_movers() {
  walls_.resize(still_walls_);
  for (const Disc& person : people_) {
    add_sides(person, kClothes);
  }
  for (const Disc& robot : robots_) {
    add_sides(robot, kHull);
  }
}

void FloorPlan::add_sides(const Disc& disc, const Surface& surface) {
  const auto corner_m = [&](std::size_t i) {
    return Eigen::Vector2d(disc.middle_m + disc.radius_m * disc_corners().at(i));
  };
  for (std::size_t i = 0; i < kDiscSides; ++i) {
    walls_.push_back({{corner_m(i), corner_m(i + 1)}, surface});
  }
}

FloorPlan FloorPlan::starting_at(const geometry::Pose2& T_world_start) const {
  if (!is_free(T_world_start.position_m())) {
    throw std::invalid_argument("start: it is not in the free space of the room");
  }
  FloorPlan moved = *this;
  moved.T_world_start_ = T_world_start;
  return moved;
}

FloorPlan FloorPlan::with_radiation(const std::vector<Source>& sources) const {
  FloorPlan other = *this;
  std::vector<Source>& all = other.marks_.sources;
  std::erase_if(all, [](const Source& one) { return one.kind == SourceKind::kRadiation; });
  all.insert(all.end(), sources.begin(), sources.end());
  other.check_sources();
  return other;
}

}  // namespace echomap::world
