// SPDX-License-Identifier: MIT
#include "host/geometry/polygon_simplification.hpp"

#include <algorithm>
#include <utility>

namespace echomap::geometry {
namespace {

/// Marks the points that stay between two that do.
void keep_between(const std::vector<Eigen::Vector2d>& way_m,
                  double tolerance_m,
                  std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> pieces{{0, way_m.size() - 1}};
  while (!pieces.empty()) {
    const auto [first, last] = pieces.back();
    pieces.pop_back();
    const Segment piece{way_m[first], way_m[last]};
    double farthest_m = tolerance_m;
    std::size_t farthest = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off_m = distance_m(piece, way_m[i]);
      if (off_m > farthest_m) {
        farthest_m = off_m;
        farthest = i;
      }
    }
    if (farthest != first) {
      kept[farthest] = true;
      pieces.emplace_back(first, farthest);
      pieces.emplace_back(farthest, last);
    }
  }
}

/// Index of the corner farthest from a place.
std::size_t farthest_corner(const Polygon& polygon, const Eigen::Vector2d& place_m) {
  const auto farthest = std::max_element(
      polygon.begin(), polygon.end(), [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return (a - place_m).squaredNorm() < (b - place_m).squaredNorm();
      });
  return static_cast<std::size_t>(farthest - polygon.begin());
}

}  // namespace

std::vector<Eigen::Vector2d> simplified_way(const std::vector<Eigen::Vector2d>& way_m,
                                            double tolerance_m) {
  if (way_m.size() < 3) {
    return way_m;
  }
  std::vector<bool> kept(way_m.size(), false);
  kept.front() = kept.back() = true;
  keep_between(way_m, tolerance_m, kept);
  std::vector<Eigen::Vector2d> simple_m;
  for (std::size_t i = 0; i < way_m.size(); ++i) {
    if (kept[i]) {
      simple_m.push_back(way_m[i]);
    }
  }
  return simple_m;
}

Polygon simplified_polygon(const Polygon& polygon, double tolerance_m) {
  if (polygon.size() < 3) {
    return polygon;
  }
  Polygon turned = polygon;
  const std::size_t first = farthest_corner(polygon, polygon.front());
  std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
  const auto middle =
      turned.begin() + static_cast<std::ptrdiff_t>(farthest_corner(turned, turned.front()));
  Polygon there(turned.begin(), middle + 1);
  Polygon back(middle, turned.end());
  back.push_back(turned.front());
  Polygon simple = simplified_way(there, tolerance_m);
  const Polygon rest = simplified_way(back, tolerance_m);
  simple.insert(simple.end(), rest.begin() + 1, rest.end() - 1);
  return simple;
}

}  // namespace echomap::geometry
