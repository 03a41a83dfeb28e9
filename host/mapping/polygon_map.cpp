// SPDX-License-Identifier: MIT
#include "host/mapping/polygon_map.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/polygon_simplification.hpp"
#include "host/geometry/touching_sides.hpp"
#include "host/mapping/raster_outline.hpp"

namespace echomap::mapping {
namespace {

using geometry::Polygon;
using geometry::SimplifiedRing;

void orient(Polygon& ring, bool counter_clockwise) {
  if ((geometry::signed_area_m2(ring) > 0.0) != counter_clockwise) {
    std::reverse(ring.begin(), ring.end());
  }
}

/// What keeps rings, outline first, from being a floor, and the sides that would have to change.
struct Fault {
  std::string text;
  std::vector<geometry::RingSide> sides;
};

std::vector<geometry::RingSide> all_sides(const std::vector<Polygon>& rings, std::size_t ring) {
  std::vector<geometry::RingSide> sides;
  for (std::size_t i = 0; i < rings[ring].size(); ++i) {
    sides.push_back({ring, i});
  }
  return sides;
}

std::size_t nearest_side(const Polygon& ring, const Eigen::Vector2d& place_m) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if (geometry::distance_m(geometry::side(ring, i), place_m) <
        geometry::distance_m(geometry::side(ring, nearest), place_m)) {
      nearest = i;
    }
  }
  return nearest;
}

void add_corner_faults(const std::vector<Polygon>& rings, std::vector<Fault>& faults) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (auto text = geometry::corner_fault(rings[i])) {
      faults.push_back({std::move(*text), all_sides(rings, i)});
    }
  }
}

void add_crossings(const std::vector<Polygon>& rings, std::vector<Fault>& faults) {
  const auto name = [](const geometry::RingSide& side) {
    return "side " + std::to_string(side.side) + " of ring " + std::to_string(side.ring);
  };
  for (const auto& [first, second] : geometry::touching_sides(rings)) {
    faults.push_back({name(first) + " and " + name(second) + " cross", {first, second}});
  }
}

void add_stray_holes(const std::vector<Polygon>& rings, std::vector<Fault>& faults) {
  for (std::size_t i = 1; i < rings.size(); ++i) {
    const Eigen::Vector2d& place_m = rings[i].front();
    if (!geometry::contains(rings.front(), place_m)) {
      faults.push_back({"hole " + std::to_string(i - 1) + " is not inside of the outline",
                        {{0, nearest_side(rings.front(), place_m)}}});
    }
  }
}

std::vector<Fault> faults_of(const std::vector<Polygon>& rings) {
  std::vector<Fault> faults;
  add_corner_faults(rings, faults);
  if (faults.empty()) {
    add_crossings(rings, faults);
    add_stray_holes(rings, faults);
  }
  return faults;
}

/// Splits these sides where that is possible; whether it was for any.
bool split(const std::set<geometry::RingSide>& sides, std::vector<SimplifiedRing>& rings) {
  bool any = false;
  // From the last on: a split moves the sides behind it.
  for (auto side = sides.rbegin(); side != sides.rend(); ++side) {
    any = rings[side->ring].split(side->side) || any;
  }
  return any;
}

/// As simple as `tolerance_m` allows, finer where sides would cross; the rings themselves, which
/// have no fault, where that does not help.
std::vector<Polygon> simplified(const std::vector<Polygon>& rings, double tolerance_m) {
  std::vector<SimplifiedRing> simple;
  simple.reserve(rings.size());
  for (const Polygon& ring : rings) {
    simple.emplace_back(ring, tolerance_m);
  }
  while (true) {
    std::vector<Polygon> polygons;
    polygons.reserve(simple.size());
    for (const SimplifiedRing& ring : simple) {
      polygons.push_back(ring.polygon());
    }
    std::set<geometry::RingSide> wrong;
    for (const Fault& fault : faults_of(polygons)) {
      wrong.insert(fault.sides.begin(), fault.sides.end());
    }
    if (wrong.empty()) {
      return polygons;
    }
    if (!split(wrong, simple)) {
      return rings;
    }
  }
}

void validate(const PolygonMapParams& params) {
  geometry::ParameterValidator("polygon map")
      .at_least("tolerance_m", params.tolerance_m, 0)
      .at_least("min_hole_m2", params.min_hole_m2, 0);
}

PolygonMap map_of(std::vector<Polygon> rings) {
  Polygon outline = std::move(rings.front());
  rings.erase(rings.begin());
  return PolygonMap(std::move(outline), std::move(rings));
}

}  // namespace

PolygonMap::PolygonMap(Polygon outline_m, std::vector<Polygon> holes_m)
    : outline_m_(std::move(outline_m)), holes_m_(std::move(holes_m)) {
  std::vector<Polygon> rings{outline_m_};
  rings.insert(rings.end(), holes_m_.begin(), holes_m_.end());
  if (const auto faults = faults_of(rings); !faults.empty()) {
    throw std::invalid_argument("no polygon map: " + faults.front().text);
  }
  orient(outline_m_, true);
  for (Polygon& hole_m : holes_m_) {
    orient(hole_m, false);
  }
}

bool PolygonMap::contains(const Eigen::Vector2d& point_m) const {
  return geometry::contains(outline_m_, point_m) &&
         std::none_of(holes_m_.begin(), holes_m_.end(), [&](const Polygon& hole_m) {
           return geometry::contains(hole_m, point_m) ||
                  geometry::distance_to_sides_m(hole_m, point_m) == 0.0;
         });
}

double PolygonMap::area_m2() const {
  double area_m2 = geometry::signed_area_m2(outline_m_);
  for (const Polygon& hole_m : holes_m_) {
    area_m2 += geometry::signed_area_m2(hole_m);
  }
  return area_m2;
}

CornerKind corner_kind(const Polygon& ring, std::size_t index) {
  const Eigen::Vector2d& before = ring[(index + ring.size() - 1) % ring.size()];
  const Eigen::Vector2d& after = ring[(index + 1) % ring.size()];
  const double turn = geometry::cross(ring[index] - before, after - ring[index]);
  return turn < 0.0 ? CornerKind::kReflex : CornerKind::kNonReflex;
}

std::optional<PolygonMap> polygon_from_raster(const RasterMap& map,
                                              const PolygonMapParams& params) {
  validate(params);
  std::vector<Polygon> rings = free_floor_rings(map);
  if (rings.empty()) {
    return std::nullopt;
  }
  std::erase_if(rings, [&](const Polygon& ring) {
    const double area_m2 = geometry::signed_area_m2(ring);
    return area_m2 < 0.0 && -area_m2 < params.min_hole_m2;
  });
  return map_of(simplified(rings, params.tolerance_m));
}

}  // namespace echomap::mapping
