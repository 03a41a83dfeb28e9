// SPDX-License-Identifier: MIT
#include "host/mapping/wall_lines.hpp"

#include <algorithm>
#include <cmath>

#include "host/mapping/line_fit.hpp"

namespace echomap::mapping {
namespace {

using geometry::Segment;

/// Only how the deviations of points compare with each other matters to a fit.
constexpr double kPointStddevM = 0.01;
constexpr double kSampleSpacingM = 0.05;
/// Below it two lines are parallel.
constexpr double kMinSine = 1e-6;

bool lies_on(const Segment& piece, const DirectedLine& line, double tolerance_m) {
  return line.direction.dot(piece.to_m - piece.from_m) > 0.0 &&
         std::abs(line.left_m(piece.from_m)) <= tolerance_m &&
         std::abs(line.left_m(piece.to_m)) <= tolerance_m;
}

/// Every piece counts by its length.
DirectedLine line_along(const std::vector<Segment>& pieces) {
  const Eigen::Vector2d direction = pieces.front().to_m - pieces.front().from_m;
  std::vector<Eigen::Vector2d> points_m;
  for (const Segment& piece : pieces) {
    const int steps = std::max(1, static_cast<int>(piece.length_m() / kSampleSpacingM));
    for (int step = 0; step <= steps; ++step) {
      points_m.emplace_back(piece.from_m + step * (piece.to_m - piece.from_m) / steps);
    }
  }
  std::stable_sort(points_m.begin(), points_m.end(), [&](const auto& a, const auto& b) {
    return direction.dot(a) < direction.dot(b);
  });
  return line_through(points_m);
}

}  // namespace

double DirectedLine::left_m(const Eigen::Vector2d& place_m) const {
  return geometry::cross(direction, place_m - point_m);
}

Eigen::Vector2d DirectedLine::foot_of(const Eigen::Vector2d& place_m) const {
  return point_m + direction.dot(place_m - point_m) * direction;
}

std::optional<Eigen::Vector2d> DirectedLine::crossing(const DirectedLine& other) const {
  const double sine = geometry::cross(direction, other.direction);
  if (std::abs(sine) < kMinSine) {
    return std::nullopt;
  }
  return point_m + geometry::cross(other.point_m - point_m, other.direction) / sine * direction;
}

DirectedLine line_through(const std::vector<Eigen::Vector2d>& points_m) {
  const Segment fitted = fit_line(points_m, kPointStddevM).segment;
  return {fitted.from_m, (fitted.to_m - fitted.from_m).normalized()};
}

std::vector<MergedWall> merged_walls(std::vector<Segment> pieces, double tolerance_m) {
  std::erase_if(pieces, [](const Segment& piece) { return piece.length_m() < kSampleSpacingM; });
  std::stable_sort(pieces.begin(), pieces.end(), [](const Segment& a, const Segment& b) {
    return a.length_m() > b.length_m();
  });
  std::vector<MergedWall> walls;
  for (const Segment& piece : pieces) {
    const auto same = std::find_if(walls.begin(), walls.end(), [&](const MergedWall& wall) {
      return lies_on(piece, wall.line, tolerance_m);
    });
    if (same == walls.end()) {
      walls.push_back({line_along({piece}), {piece}});
      continue;
    }
    same->pieces.push_back(piece);
    same->line = line_along(same->pieces);
  }
  return walls;
}

}  // namespace echomap::mapping
