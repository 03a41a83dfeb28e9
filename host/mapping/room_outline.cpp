// SPDX-License-Identifier: MIT
#include "host/mapping/room_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/polygon_simplification.hpp"
#include "host/geometry/touching_sides.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/raster_outline.hpp"
#include "host/mapping/unknown_slivers.hpp"

namespace echomap::mapping {
namespace {

using geometry::Polygon;

constexpr int kCircleCorners = 16;
/// A hole of the floor whose middle is this near to a circle is the circle's.
constexpr double kCircleMarginM = 0.10;
/// Of the area of a hole by its straight sides, as a factor.
constexpr double kMaxHoleChange = 1.5;

void validate(const RoomOutlineParams& room) {
  const OutlineSideParams& params = room.sides;
  geometry::ParameterValidator("room outline")
      .nonnegative_finite("sliver_m", room.sliver_m)
      .positive_finite("max_deviation_m", params.lines.max_deviation_m)
      .nonnegative_finite("reach_m", params.lines.reach_m)
      .nonnegative_finite("bridged_m", params.lines.bridged_m)
      .within("bridged_share", params.lines.bridged_share, 0.0, 1.0)
      .within("unknown_share", params.lines.unknown_share, 0.0, 1.0)
      .within("behind_share", params.lines.behind_share, 0.0, 1.0)
      .nonnegative_finite("own_line_m", params.lines.own_line_m)
      .nonnegative_finite("own_direction_m", params.lines.own_direction_m)
      .positive_finite("cut_tolerance_m", params.lines.cut_tolerance_m)
      .nonnegative_finite("max_loop_m2", params.max_loop_m2)
      .positive_finite("corner_cost_m", params.sequence.corner_cost_m)
      .positive_finite("corner_reach_m", params.sequence.corner_reach_m)
      .positive_finite("floor_corner_reach_m", params.sequence.floor_corner_reach_m)
      .within("min_turn_rad", params.sequence.min_turn_rad, 0.01, 1.0);
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
    std::vector<Polygon> rings{straight(borders_m.front())};
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
          !add_straight(border_m, rings) && !add_hole(thinned(border_m), rings)) {
        add_hole(border_m, rings);
      }
    }
    return rings;
  }

 private:
  Polygon straight(const Polygon& border_m) const {
    return straight_outline(border_m, map_, features_.walls, params_.sides);
  }

  /// The sides of a small hole may be all detail: no straight lines are left that enclose it.
  bool add_straight(const Polygon& border_m, std::vector<Polygon>& rings) const {
    Polygon hole_m = straight(border_m);
    const double share = geometry::signed_area_m2(hole_m) / geometry::signed_area_m2(border_m);
    return share > 1.0 / kMaxHoleChange && share < kMaxHoleChange &&
           add_hole(std::move(hole_m), rings);
  }

  Polygon thinned(const Polygon& border_m) const {
    return geometry::SimplifiedRing(border_m, params_.border.tolerance_m).polygon();
  }

  const RasterMap& map_;
  const SonarFeatures& features_;
  const RoomOutlineParams& params_;
};

}  // namespace

std::optional<PolygonMap> room_outline(const RasterMap& map,
                                       const SonarFeatures& features,
                                       const RoomOutlineParams& params) {
  validate(params);
  const RasterMap filled = without_unknown_slivers(map, params.sliver_m);
  auto borders_m = free_floor_rings(filled);
  if (borders_m.empty() || (features.walls.empty() && features.circles.empty())) {
    return polygon_from_raster(map, params.border);
  }
  auto rings = RoomOutline(filled, features, params).rings(std::move(borders_m));
  if (rings.empty()) {
    return polygon_from_raster(map, params.border);
  }
  Polygon outline = std::move(rings.front());
  rings.erase(rings.begin());
  return PolygonMap(std::move(outline), std::move(rings));
}

}  // namespace echomap::mapping
