// SPDX-License-Identifier: MIT
#include "host/mapping/floor_border.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/segment.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

/// Edges to both sides that the direction out of the floor is the mean of: a single edge of a
/// staircase tells no direction.
constexpr std::size_t kMeanReach = 3;

bool is_occupied(const RasterMap& map, const Eigen::Vector2d& point_m) {
  return map.state(map.cell_at(point_m)) == CellState::kOccupied;
}

}  // namespace

std::vector<BorderPoint> border_points(const geometry::Polygon& border_m, const RasterMap& map) {
  std::vector<BorderPoint> points;
  std::vector<Eigen::Vector2d> normals;
  for (std::size_t i = 0; i < border_m.size(); ++i) {
    const geometry::Segment side = geometry::side(border_m, i);
    const Eigen::Vector2d normal = -geometry::left_normal(side);
    const auto edges = std::lround(side.length_m() / map.resolution_m());
    for (long edge = 0; edge < edges; ++edge) {
      const double share = (static_cast<double>(edge) + 0.5) / static_cast<double>(edges);
      const Eigen::Vector2d middle_m = side.from_m + share * (side.to_m - side.from_m);
      const Eigen::Vector2d cell_m = map.resolution_m() * normal;
      points.push_back(
          {middle_m,
           Eigen::Vector2d::Zero(),
           is_occupied(map, middle_m + 0.5 * cell_m) || is_occupied(map, middle_m + 1.5 * cell_m)});
      normals.push_back(normal);
    }
  }
  const std::size_t reach = std::min(kMeanReach, points.size() / 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = points.size() + i - reach; j <= points.size() + i + reach; ++j) {
      points[i].outward += normals[j % points.size()] / static_cast<double>(2 * reach + 1);
    }
  }
  return points;
}

Eigen::Vector2d joint_m(const std::vector<BorderPoint>& border, std::size_t point) {
  const std::size_t before = (point + border.size() - 1) % border.size();
  return 0.5 * (border[before].position_m + border[point % border.size()].position_m);
}

bool is_unknown_up_to(const RasterMap& map,
                      const Eigen::Vector2d& border_m,
                      const Eigen::Vector2d& place_m,
                      double wall_m) {
  const Eigen::Vector2d offset_m = place_m - border_m;
  const double length_m = offset_m.norm() - wall_m;
  const double step_m = 0.5 * map.resolution_m();
  // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): no step counts, cells are far wider
  for (double at_m = 1.5 * step_m; at_m < length_m; at_m += step_m) {
    const Eigen::Vector2d point_m = border_m + at_m * offset_m.normalized();
    if (map.state(map.cell_at(point_m)) != CellState::kUnknown) {
      return false;
    }
  }
  return true;
}

}  // namespace echomap::mapping
