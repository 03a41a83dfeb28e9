// SPDX-License-Identifier: MIT
#include "host/geometry/reflex_outline.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace echomap::geometry {

namespace {

bool is_reflex(const Polygon& outline_m, std::size_t index) {
  const std::size_t count = outline_m.size();
  const Eigen::Vector2d& here_m = outline_m[index];
  return cross(here_m - outline_m[(index + count - 1) % count],
               outline_m[(index + 1) % count] - here_m) < 0.0;
}

/// Whether a point lies to the left of the way, by arithmetic that is the same for the way back.
bool is_left(const Eigen::Vector2d& from_m,
             const Eigen::Vector2d& to_m,
             const Eigen::Vector2d& point_m) {
  const bool is_up = from_m.y() < to_m.y();
  const Eigen::Vector2d& low_m = is_up ? from_m : to_m;
  const Eigen::Vector2d& high_m = is_up ? to_m : from_m;
  return (cross(high_m - low_m, point_m - low_m) > 0.0) == is_up;
}

/// How a side winds about a point: 1 where it passes on its right upwards, -1 downwards.
int winding(const Eigen::Vector2d& from_m,
            const Eigen::Vector2d& to_m,
            const Eigen::Vector2d& point_m) {
  const bool is_below = from_m.y() <= point_m.y();
  if (is_below == (to_m.y() <= point_m.y())) {
    return 0;
  }
  if (is_below) {
    return is_left(from_m, to_m, point_m) ? 1 : 0;
  }
  return is_left(from_m, to_m, point_m) ? 0 : -1;
}

int winding(const ReflexOutline::Triangle& triangle, const Eigen::Vector2d& point_m) {
  return winding(triangle.a_m, triangle.b_m, point_m) +
         winding(triangle.b_m, triangle.c_m, point_m) +
         winding(triangle.c_m, triangle.a_m, point_m);
}

}  // namespace

ReflexCut cut_reflex_corners(const Polygon& outline_m) {
  const std::size_t count = outline_m.size();
  std::vector<bool> reflex(count);
  for (std::size_t i = 0; i < count; ++i) {
    reflex[i] = is_reflex(outline_m, i);
  }
  const auto first = std::find(reflex.begin(), reflex.end(), false);
  if (first == reflex.end()) {
    return {outline_m, {}};
  }
  const auto start = static_cast<std::size_t>(first - reflex.begin());
  ReflexCut cut;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t here = (start + i) % count;
    const std::size_t next = (here + 1) % count;
    if (!reflex[here]) {
      cut.outer_m.push_back(outline_m[here]);
      if (reflex[next]) {
        cut.parts_m.push_back({outline_m[here]});
      }
      continue;
    }
    cut.parts_m.back().push_back(outline_m[here]);
    if (!reflex[next]) {
      cut.parts_m.back().push_back(outline_m[next]);
    }
  }
  return cut;
}

ReflexOutline::ReflexOutline(Polygon outline_m) {
  if (const auto fault = polygon_fault(outline_m)) {
    throw std::invalid_argument("outline: " + *fault);
  }
  if (signed_area_m2(outline_m) < 0.0) {
    std::reverse(outline_m.begin(), outline_m.end());
  }
  while (true) {
    ReflexCut cut = cut_reflex_corners(outline_m);
    for (const Polygon& part_m : cut.parts_m) {
      add_fan(part_m);
    }
    outline_m = std::move(cut.outer_m);
    if (cut.parts_m.empty()) {
      break;
    }
  }
  add_fan(outline_m);
}

void ReflexOutline::add_fan(const Polygon& corners_m) {
  for (std::size_t i = 1; i + 1 < corners_m.size(); ++i) {
    triangles_.push_back({corners_m[0], corners_m[i], corners_m[i + 1]});
  }
}

bool ReflexOutline::contains(const Eigen::Vector2d& point_m) const {
  int turns = 0;
  for (const Triangle& triangle : triangles_) {
    turns += winding(triangle, point_m);
  }
  return turns != 0;
}

}  // namespace echomap::geometry
