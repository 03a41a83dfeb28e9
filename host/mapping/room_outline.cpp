// SPDX-License-Identifier: MIT
#include "host/mapping/room_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/touching_sides.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/raster_outline.hpp"
#include "host/mapping/wall_lines.hpp"

namespace echomap::mapping {
namespace {

using geometry::Polygon;
using geometry::Segment;

constexpr int kCircleCorners = 16;
/// A hole of the floor whose middle is this near to a circle is the circle's.
constexpr double kCircleMarginM = 0.10;
/// A corner this near to the straight piece between its neighbours is none.
constexpr double kStraightM = 0.001;
/// A wall is along a side if both its ends are this near to the side's line.
constexpr double kAlongSideM = 0.05;

void validate(const OutlineSideParams& params) {
  geometry::ParameterValidator("room outline")
      .positive_finite("cut_tolerance_m", params.cut_tolerance_m)
      .positive_finite("wall_distance_m", params.wall_distance_m)
      .nonnegative_finite("wall_gap_m", params.wall_gap_m)
      .positive_finite("detail_m", params.detail_m)
      .within("min_turn_rad", params.min_turn_rad, 0.01, 1.0)
      .nonnegative_finite("bridged_m", params.bridged_m)
      .positive_finite("known_length_m", params.known_length_m);
}

/// Clockwise, as holes are.
Polygon polygon_of(const FittedCircle& circle) {
  Polygon polygon;
  for (int i = 0; i < kCircleCorners; ++i) {
    const double bearing_rad = -2.0 * std::numbers::pi * i / kCircleCorners;
    polygon.emplace_back(circle.center_m + circle.radius_m * geometry::unit_vector(bearing_rad));
  }
  return polygon;
}

Eigen::Vector2d middle_of(const Polygon& ring) {
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner_m : ring) {
    sum_m += corner_m;
  }
  return sum_m / static_cast<double>(ring.size());
}

/// Whether all of a hole is the place of that circle.
bool is_border_of(const FittedCircle& circle, const Polygon& hole_m) {
  return std::all_of(hole_m.begin(),
                     hole_m.end(),
                     [&](const Eigen::Vector2d& corner_m) {
                       return (corner_m - circle.center_m).norm() <=
                              circle.radius_m + 2.0 * kCircleMarginM;
                     }) &&
         (middle_of(hole_m) - circle.center_m).norm() <= kCircleMarginM;
}

/// Whether a circle is a part of what one hole encloses, so that it is no hole of its own.
bool is_within_any(const FittedCircle& circle, const std::vector<Polygon>& holes_m) {
  return std::any_of(holes_m.begin(), holes_m.end(), [&](const Polygon& hole_m) {
    return geometry::contains(hole_m, circle.center_m) && !is_border_of(circle, hole_m);
  });
}

DirectedLine line_of(const Segment& side) {
  return {side.from_m, (side.to_m - side.from_m).normalized()};
}

Polygon without_straight_corners(Polygon ring_m) {
  std::size_t checked = 0;
  for (std::size_t i = 0; ring_m.size() > 3 && checked < ring_m.size();) {
    i %= ring_m.size();
    const Segment between{ring_m[(i + ring_m.size() - 1) % ring_m.size()],
                          ring_m[(i + 1) % ring_m.size()]};
    if (geometry::distance_m(between, ring_m[i]) < kStraightM) {
      ring_m.erase(ring_m.begin() + static_cast<std::ptrdiff_t>(i));
      i += ring_m.size() - 1;
      checked = 0;
    } else {
      ++i;
      ++checked;
    }
  }
  return ring_m;
}

/// A crossing divides a ring into two loops: the larger one, if the other is no larger than
/// `max_loop_m2`.
std::optional<Polygon> without_loop(const Polygon& ring_m,
                                    const geometry::TouchingSides& crossing,
                                    double max_loop_m2) {
  const auto [first, second] = std::pair(crossing.first.side, crossing.second.side);
  const auto crossing_m =
      line_of(geometry::side(ring_m, first)).crossing(line_of(geometry::side(ring_m, second)));
  if (!crossing_m) {
    return std::nullopt;
  }
  const auto begin = ring_m.begin() + static_cast<std::ptrdiff_t>(first) + 1;
  const auto end = ring_m.begin() + static_cast<std::ptrdiff_t>(second) + 1;
  Polygon loop_m(begin, end);
  loop_m.push_back(*crossing_m);
  Polygon rest_m(ring_m.begin(), begin);
  rest_m.push_back(*crossing_m);
  rest_m.insert(rest_m.end(), end, ring_m.end());
  if (std::abs(geometry::signed_area_m2(loop_m)) > std::abs(geometry::signed_area_m2(rest_m))) {
    std::swap(loop_m, rest_m);
  }
  return std::abs(geometry::signed_area_m2(loop_m)) <= max_loop_m2 ? std::optional(rest_m)
                                                                   : std::nullopt;
}

/// Cuts off small loops; larger ones stay, and the sides that cross with them.
Polygon without_small_loops(Polygon ring_m, double max_loop_m2) {
  ring_m = without_straight_corners(std::move(ring_m));
  // A cut takes at least one corner.
  while (ring_m.size() > 3) {
    const auto crossings = geometry::touching_sides({ring_m});
    auto rest_m =
        crossings.empty() ? std::nullopt : without_loop(ring_m, crossings.front(), max_loop_m2);
    if (!rest_m) {
      break;
    }
    ring_m = without_straight_corners(std::move(*rest_m));
  }
  return ring_m;
}

bool is_along(const Segment& wall, const Segment& side) {
  const DirectedLine line = line_of(side);
  return line.direction.dot(wall.to_m - wall.from_m) > 0.0 &&
         std::abs(line.left_m(wall.from_m)) <= kAlongSideM &&
         std::abs(line.left_m(wall.to_m)) <= kAlongSideM;
}

/// Whether there were any along sides that cross.
bool erase_walls_of_crossing_sides(const Polygon& ring_m, std::vector<Segment>& walls) {
  const auto crossings = geometry::touching_sides({ring_m});
  return std::erase_if(walls, [&](const Segment& wall) {
           return std::any_of(
               crossings.begin(), crossings.end(), [&](const geometry::TouchingSides& crossing) {
                 return is_along(wall, geometry::side(ring_m, crossing.first.side)) ||
                        is_along(wall, geometry::side(ring_m, crossing.second.side));
               });
         }) > 0;
}

bool is_outline(const std::vector<Polygon>& rings) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (geometry::corner_fault(rings[i]) ||
        (geometry::signed_area_m2(rings[i]) > 0.0) != (i == 0) ||
        (i > 0 && !geometry::contains(rings.front(), rings[i].front()))) {
      return false;
    }
  }
  return geometry::touching_sides(rings).empty();
}

/// Adds a hole if what there is remains a floor with holes.
bool add_hole(Polygon hole_m, std::vector<Polygon>& rings) {
  rings.push_back(std::move(hole_m));
  if (is_outline(rings)) {
    return true;
  }
  rings.pop_back();
  return false;
}

class RoomOutline {
 public:
  RoomOutline(const RasterMap& map, const SonarFeatures& features, const RoomOutlineParams& params)
      : map_(map), features_(features), params_(params) {}

  /// The rings of the outline; empty where its sides cross.
  std::vector<Polygon> rings(std::vector<Polygon> borders_m) const {
    std::vector<Polygon> rings{straight_where_possible(borders_m.front())};
    if (!is_outline(rings)) {
      return {};
    }
    borders_m.erase(borders_m.begin());
    for (const FittedCircle& circle : features_.circles) {
      if (!is_within_any(circle, borders_m) && add_hole(polygon_of(circle), rings)) {
        std::erase_if(borders_m,
                      [&](const Polygon& border_m) { return is_border_of(circle, border_m); });
      }
    }
    for (const Polygon& border_m : borders_m) {
      if (-geometry::signed_area_m2(border_m) >= params_.border.min_hole_m2 &&
          !add_hole(straight(border_m, features_.walls), rings)) {
        add_hole(border_m, rings);
      }
    }
    return rings;
  }

 private:
  /// Follows as many of the walls as it can without sides that cross. They may cross still.
  Polygon straight_where_possible(const Polygon& border_m) const {
    std::vector<Segment> walls = features_.walls;
    Polygon outline_m = straight(border_m, walls);
    while (erase_walls_of_crossing_sides(outline_m, walls)) {
      outline_m = straight(border_m, walls);
    }
    return outline_m;
  }

  Polygon straight(const Polygon& border_m, const std::vector<Segment>& walls) const {
    return without_small_loops(straight_outline(border_m, map_, walls, params_.sides),
                               params_.border.min_hole_m2);
  }

  const RasterMap& map_;
  const SonarFeatures& features_;
  const RoomOutlineParams& params_;
};

}  // namespace

std::optional<PolygonMap> room_outline(const RasterMap& map,
                                       const SonarFeatures& features,
                                       const RoomOutlineParams& params) {
  validate(params.sides);
  auto borders_m = free_floor_rings(map);
  if (borders_m.empty() || (features.walls.empty() && features.circles.empty())) {
    return polygon_from_raster(map, params.border);
  }
  auto rings = RoomOutline(map, features, params).rings(std::move(borders_m));
  if (rings.empty()) {
    return polygon_from_raster(map, params.border);
  }
  Polygon outline = std::move(rings.front());
  rings.erase(rings.begin());
  return PolygonMap(std::move(outline), std::move(rings));
}

}  // namespace echomap::mapping
