// SPDX-License-Identifier: MIT
#include "host/geometry/polygon.hpp"

#include <algorithm>
#include <limits>

namespace echomap::geometry {
namespace {

constexpr double kTouchM = 1e-9;

std::string sides_text(std::size_t first, std::size_t second) {
  return "sides " + std::to_string(first) + " and " + std::to_string(second);
}

/// Neighbours share a corner; they may not fold back onto each other.
bool folds_back(const Segment& first, const Segment& second) {
  const Eigen::Vector2d a = first.to_m - first.from_m;
  const Eigen::Vector2d b = second.to_m - second.from_m;
  return std::abs(cross(a, b)) < kTouchM * a.norm() * b.norm() && a.dot(b) < 0.0;
}

std::optional<std::string> repeated_corner(const Polygon& polygon, std::size_t index) {
  const Segment here = side(polygon, index);
  if ((here.to_m - here.from_m).norm() >= kTouchM) {
    return std::nullopt;
  }
  return "corners " + std::to_string(index) + " and " +
         std::to_string((index + 1) % polygon.size()) + " are the same";
}

std::optional<std::string> crossed_side(const Polygon& polygon, std::size_t first) {
  const std::size_t count = polygon.size();
  const Segment here = side(polygon, first);
  if (folds_back(here, side(polygon, (first + 1) % count))) {
    return sides_text(first, (first + 1) % count) + " lie on each other";
  }
  for (std::size_t second = first + 2; second < count; ++second) {
    const bool neighbours = (second + 1) % count == first;
    if (!neighbours && touch(here, side(polygon, second))) {
      return sides_text(first, second) + " cross";
    }
  }
  return std::nullopt;
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
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    least_m = std::min(least_m, (nearest_point(side(polygon, i), point_m) - point_m).norm());
  }
  return least_m;
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

std::optional<std::string> polygon_fault(const Polygon& polygon) {
  if (polygon.size() < 3) {
    return "a polygon needs at least 3 corners, here are " + std::to_string(polygon.size());
  }
  for (const auto& check : {repeated_corner, crossed_side}) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      if (auto fault = check(polygon, i)) {
        return fault;
      }
    }
  }
  return std::nullopt;
}

}  // namespace echomap::geometry
