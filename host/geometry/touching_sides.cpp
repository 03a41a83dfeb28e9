// SPDX-License-Identifier: MIT
#include "host/geometry/touching_sides.hpp"

#include <algorithm>
#include <cmath>

namespace echomap::geometry {
namespace {

/// Sides that miss each other by less than this may still touch.
constexpr double kMarginM = 1e-6;

struct SweptSide {
  RingSide name;
  Segment segment;
  Eigen::Vector2d low_m;
  Eigen::Vector2d high_m;
};

std::vector<SweptSide> from_left_to_right(const std::vector<Polygon>& rings) {
  std::vector<SweptSide> sides;
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    for (std::size_t i = 0; i < rings[ring].size(); ++i) {
      const Segment here = side(rings[ring], i);
      sides.push_back({{ring, i},
                       here,
                       here.from_m.cwiseMin(here.to_m).array() - kMarginM,
                       here.from_m.cwiseMax(here.to_m).array() + kMarginM});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const SweptSide& a, const SweptSide& b) {
    return a.low_m.x() < b.low_m.x();
  });
  return sides;
}

bool follow_each_other(const RingSide& a, const RingSide& b, const std::vector<Polygon>& rings) {
  const std::size_t count = rings[a.ring].size();
  return a.ring == b.ring && ((a.side + 1) % count == b.side || (b.side + 1) % count == a.side);
}

/// Of two sides that share the corner in which one of them ends.
bool folds_back(const Segment& first, const Segment& second) {
  constexpr double kStraight = 1e-9;
  const Eigen::Vector2d a = first.to_m - first.from_m;
  const Eigen::Vector2d b = second.to_m - second.from_m;
  return std::abs(cross(a, b)) < kStraight * a.norm() * b.norm() && a.dot(b) < 0.0;
}

bool meet(const SweptSide& a, const SweptSide& b, const std::vector<Polygon>& rings) {
  if (a.low_m.y() > b.high_m.y() || b.low_m.y() > a.high_m.y()) {
    return false;
  }
  return follow_each_other(a.name, b.name, rings) ? folds_back(a.segment, b.segment)
                                                  : touch(a.segment, b.segment);
}

}  // namespace

std::vector<TouchingSides> touching_sides(const std::vector<Polygon>& rings) {
  const std::vector<SweptSide> sides = from_left_to_right(rings);
  std::vector<TouchingSides> found;
  for (auto here = sides.begin(); here != sides.end(); ++here) {
    for (auto next = here + 1; next != sides.end() && next->low_m.x() <= here->high_m.x(); ++next) {
      if (meet(*here, *next, rings)) {
        const auto [first, second] = std::minmax(here->name, next->name);
        found.push_back({first, second});
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace echomap::geometry
