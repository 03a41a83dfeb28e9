// SPDX-License-Identifier: MIT
#include "host/mapping/ring_loops.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "host/geometry/straight_corners.hpp"
#include "host/geometry/touching_sides.hpp"
#include "host/mapping/wall_lines.hpp"

namespace echomap::mapping {
namespace {

using geometry::Polygon;
using geometry::Segment;

/// A corner this near to the straight piece between its neighbours is none.
constexpr double kStraightM = 0.001;

DirectedLine line_of(const Segment& side) {
  return {side.from_m, (side.to_m - side.from_m).normalized()};
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

}  // namespace

Polygon without_small_loops(Polygon ring_m, double max_loop_m2) {
  ring_m = geometry::without_straight_corners(std::move(ring_m), kStraightM);
  // A cut takes at least one corner.
  while (ring_m.size() > 3) {
    std::optional<Polygon> rest_m;
    for (const auto& crossing : geometry::touching_sides({ring_m})) {
      rest_m = without_loop(ring_m, crossing, max_loop_m2);
      if (rest_m) {
        break;
      }
    }
    if (!rest_m) {
      break;
    }
    ring_m = geometry::without_straight_corners(std::move(*rest_m), kStraightM);
  }
  return ring_m;
}

}  // namespace echomap::mapping
