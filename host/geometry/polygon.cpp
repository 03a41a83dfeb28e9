// SPDX-License-Identifier: MIT
#include "host/geometry/polygon.hpp"

#include <algorithm>
#include <limits>

#include "host/geometry/touching_sides.hpp"

namespace echomap::geometry {
namespace {

constexpr double kTouchM = 1e-9;

std::optional<std::string> repeated_corner(const Polygon& polygon, std::size_t index) {
  const Segment here = side(polygon, index);
  if ((here.to_m - here.from_m).norm() >= kTouchM) {
    return std::nullopt;
  }
  return "corners " + std::to_string(index) + " and " +
         std::to_string((index + 1) % polygon.size()) + " are the same";
}

}  // namespace

Segment side(const Polygon& polygon, std::size_t index) {
  return {polygon[index], polygon[(index + 1) % polygon.size()]};
}

double signed_area_m2(const Polygon& polygon) {
  double twice_m2 = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment here = side(polygon, i);
    twice_m2 += cross(here.from_m, here.to_m);
  }
  return 0.5 * twice_m2;
}

double distance_to_sides_m(const Polygon& polygon, const Eigen::Vector2d& point_m) {
  double min_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    min_m = std::min(min_m, (nearest_point(side(polygon, i), point_m) - point_m).norm());
  }
  return min_m;
}

bool contains(const Polygon& polygon, const Eigen::Vector2d& point_m) {
  if (distance_to_sides_m(polygon, point_m) < kTouchM) {
    return false;
  }
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto [from, to] = side(polygon, i);
    const bool spans = (from.y() > point_m.y()) != (to.y() > point_m.y());
    if (spans && (cross(to - from, point_m - from) > 0.0) == (to.y() > from.y())) {
      inside = !inside;
    }
  }
  return inside;
}

bool contains(const Polygon& outer, const Polygon& inner) {
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (!contains(outer, inner[i]) && distance_to_sides_m(outer, inner[i]) >= kTouchM) {
      return false;
    }
    for (std::size_t k = 0; k < outer.size(); ++k) {
      if (cross_properly(side(inner, i), side(outer, k))) {
        return false;
      }
    }
  }
  return true;
}

std::optional<std::string> corner_fault(const Polygon& polygon) {
  if (polygon.size() < 3) {
    return "a polygon needs at least 3 corners, here are " + std::to_string(polygon.size());
  }
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (auto fault = repeated_corner(polygon, i)) {
      return fault;
    }
  }
  return std::nullopt;
}

std::optional<std::string> polygon_fault(const Polygon& polygon) {
  if (auto fault = corner_fault(polygon)) {
    return fault;
  }
  const auto touching = touching_sides({polygon});
  if (touching.empty()) {
    return std::nullopt;
  }
  const std::size_t first = touching.front().first.side;
  const std::size_t second = touching.front().second.side;
  const bool neighbours = first + 1 == second || (second + 1) % polygon.size() == first;
  return "sides " + std::to_string(first) + " and " + std::to_string(second) +
         (neighbours ? " lie on each other" : " cross");
}

}  // namespace echomap::geometry
