// SPDX-License-Identifier: MIT
#include "host/geometry/polygon_simplification.hpp"

#include <algorithm>
#include <optional>

namespace echomap::geometry {
namespace {

using Polyline = std::vector<Eigen::Vector2d>;

/// The point between `first` and `last` that is farthest from the straight piece between them, if
/// it is farther than `min_m`.
std::optional<std::size_t> farthest_between(const Polyline& polyline_m,
                                            std::size_t first,
                                            std::size_t last,
                                            double min_m) {
  const Segment piece{polyline_m[first], polyline_m[last]};
  double largest_off_m = min_m;
  std::optional<std::size_t> farthest;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double off_m = distance_m(piece, polyline_m[i]);
    if (off_m > largest_off_m) {
      largest_off_m = off_m;
      farthest = i;
    }
  }
  return farthest;
}

/// Indices of the points from `first` to `last` that stay, both ends among them.
std::vector<std::size_t> indices_between(const Polyline& polyline_m,
                                         std::size_t first,
                                         std::size_t last,
                                         double tolerance_m) {
  std::vector<std::size_t> kept{first};
  std::vector<std::size_t> ends{last};
  while (!ends.empty()) {
    if (const auto farthest = farthest_between(polyline_m, kept.back(), ends.back(), tolerance_m)) {
      ends.push_back(*farthest);
    } else {
      kept.push_back(ends.back());
      ends.pop_back();
    }
  }
  return kept;
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

SimplifiedRing::SimplifiedRing(const Polygon& ring, double tolerance_m) : polyline_m_(ring) {
  if (ring.empty()) {
    return;
  }
  const std::size_t first = farthest_corner(ring, ring.front());
  std::rotate(polyline_m_.begin(),
              polyline_m_.begin() + static_cast<std::ptrdiff_t>(first),
              polyline_m_.end());
  const std::size_t middle = farthest_corner(polyline_m_, polyline_m_.front());
  polyline_m_.push_back(polyline_m_.front());
  kept_ = indices_between(polyline_m_, 0, middle, tolerance_m);
  kept_.pop_back();
  const auto back = indices_between(polyline_m_, middle, ring.size(), tolerance_m);
  kept_.insert(kept_.end(), back.begin(), back.end());
}

Polygon SimplifiedRing::polygon() const {
  Polygon polygon;
  for (std::size_t i = 0; i + 1 < kept_.size(); ++i) {
    polygon.push_back(polyline_m_[kept_[i]]);
  }
  return polygon;
}

bool SimplifiedRing::split(std::size_t side) {
  const auto farthest = farthest_between(polyline_m_, kept_[side], kept_[side + 1], 0.0);
  if (farthest) {
    kept_.insert(kept_.begin() + static_cast<std::ptrdiff_t>(side) + 1, *farthest);
  }
  return farthest.has_value();
}

}  // namespace echomap::geometry
