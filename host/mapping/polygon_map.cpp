// SPDX-License-Identifier: MIT
#include "host/mapping/polygon_map.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "host/geometry/polygon_simplification.hpp"
#include "host/mapping/raster_outline.hpp"

namespace echomap::mapping {
namespace {

using geometry::Polygon;

/// A finer tolerance than this fraction of the wanted one is none.
constexpr double kLeastShareOfTolerance = 0.01;

void orient(Polygon& ring, bool counter_clockwise) {
  if ((geometry::signed_area_m2(ring) > 0.0) != counter_clockwise) {
    std::reverse(ring.begin(), ring.end());
  }
}

bool touch(const Polygon& first, const Polygon& second) {
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t k = 0; k < second.size(); ++k) {
      if (geometry::touch(geometry::side(first, i), geometry::side(second, k))) {
        return true;
      }
    }
  }
  return false;
}

/// Why the rings, outline first, are no floor.
std::optional<std::string> fault_of(const std::vector<Polygon>& rings) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (auto fault = geometry::polygon_fault(rings[i])) {
      return fault;
    }
    if (i > 0 && !geometry::contains(rings.front(), rings[i].front())) {
      return "hole " + std::to_string(i - 1) + " is not inside of the outline";
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (touch(rings[i], rings[k])) {
        return "rings " + std::to_string(k) + " and " + std::to_string(i) + " cross";
      }
    }
  }
  return std::nullopt;
}

/// As simple as `tolerance_m` allows without sides that cross; the rings themselves, which have no
/// fault, where nothing simpler does.
std::vector<Polygon> simplified(const std::vector<Polygon>& rings, double tolerance_m) {
  const double least_m = kLeastShareOfTolerance * tolerance_m;
  for (double finer_m = tolerance_m; finer_m > least_m; finer_m *= 0.5) {
    std::vector<Polygon> simple;
    for (const Polygon& ring : rings) {
      simple.push_back(geometry::simplified_polygon(ring, finer_m));
    }
    if (!fault_of(simple)) {
      return simple;
    }
  }
  return rings;
}

void check(const PolygonMapParams& params) {
  if (!(params.tolerance_m >= 0.0) || !(params.least_hole_m2 >= 0.0)) {
    throw std::invalid_argument("a polygon map's tolerance and least hole are not below 0");
  }
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
  if (const auto fault = fault_of(rings)) {
    throw std::invalid_argument("no polygon map: " + *fault);
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

std::optional<PolygonMap> polygon_from_contour(const std::vector<Eigen::Vector2d>& contour_m,
                                               const PolygonMapParams& params) {
  check(params);
  const Polygon whole = geometry::simplified_polygon(contour_m, 0.0);
  const std::vector<Polygon> rings = simplified({whole}, params.tolerance_m);
  if (fault_of(rings)) {
    return std::nullopt;
  }
  return map_of(rings);
}

std::optional<PolygonMap> polygon_from_raster(const RasterMap& map,
                                              const PolygonMapParams& params) {
  check(params);
  std::vector<Polygon> rings = free_floor_rings(map);
  if (rings.empty()) {
    return std::nullopt;
  }
  std::erase_if(rings, [&](const Polygon& ring) {
    const double area_m2 = geometry::signed_area_m2(ring);
    return area_m2 < 0.0 && -area_m2 < params.least_hole_m2;
  });
  return map_of(simplified(rings, params.tolerance_m));
}

}  // namespace echomap::mapping
