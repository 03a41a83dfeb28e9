// SPDX-License-Identifier: MIT
#include "host/evaluation/obstacle_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/evaluation/outline_agreement.hpp"
#include "host/geometry/point_buckets.hpp"
#include "host/geometry/polygon.hpp"

namespace echomap::evaluation {

namespace {

using geometry::Polygon;
using geometry::Pose2;
using mapping::CellState;
using mapping::RasterMap;

constexpr double kStepM = 0.01;
constexpr double kWallBandM = 0.10;
constexpr double kMinObjectM = 0.10;
constexpr double kObjectReachM = 0.075;
/// Free cells of the truth begin beside an outline, at most this far from it.
constexpr double kSkinM = 0.03;

/// Points of a lattice over the polygon's upright rectangle, `margin_m` larger, that `is_in` takes.
template <class Predicate>
std::vector<Eigen::Vector2d> lattice_points_m(const Polygon& polygon,
                                              double margin_m,
                                              const Predicate& is_in) {
  Eigen::Vector2d min_m = polygon.front();
  Eigen::Vector2d max_m = polygon.front();
  for (const Eigen::Vector2d& corner_m : polygon) {
    min_m = min_m.cwiseMin(corner_m);
    max_m = max_m.cwiseMax(corner_m);
  }
  min_m.array() -= margin_m;
  max_m.array() += margin_m;
  const Eigen::Vector2d size_m = max_m - min_m;
  const Eigen::Array2d counts = (size_m.array() / kStepM).ceil().max(1.0);
  const Eigen::Vector2d step_m = size_m.array() / counts;
  std::vector<Eigen::Vector2d> points_m;
  for (int y = 0; y < counts.y(); ++y) {
    for (int x = 0; x < counts.x(); ++x) {
      const Eigen::Vector2d point_m =
          min_m + Eigen::Vector2d(x + 0.5, y + 0.5).cwiseProduct(step_m);
      if (is_in(point_m)) {
        points_m.push_back(point_m);
      }
    }
  }
  return points_m;
}

std::vector<Eigen::Vector2d> inside_points_m(const std::vector<Polygon>& obstacles) {
  std::vector<Eigen::Vector2d> points_m;
  for (const Polygon& obstacle : obstacles) {
    const auto inside_m = lattice_points_m(obstacle, 0.0, [&](const Eigen::Vector2d& point_m) {
      return geometry::contains(obstacle, point_m);
    });
    points_m.insert(points_m.end(), inside_m.begin(), inside_m.end());
  }
  return points_m;
}

std::vector<Eigen::Vector2d> wall_band_points_m(const Polygon& room) {
  if (room.empty()) {
    return {};
  }
  return lattice_points_m(room, kWallBandM, [&](const Eigen::Vector2d& point_m) {
    return !geometry::contains(room, point_m) &&
           geometry::distance_to_sides_m(room, point_m) <= kWallBandM;
  });
}

std::optional<double> share_called_free(const RasterMap& map,
                                        const Pose2& T_map_world,
                                        const std::vector<Eigen::Vector2d>& points_m) {
  if (points_m.empty()) {
    return std::nullopt;
  }
  const auto free = std::count_if(points_m.begin(), points_m.end(), [&](const auto& point_m) {
    return map.state(map.cell_at(T_map_world * point_m)) == CellState::kFree;
  });
  return static_cast<double>(free) / static_cast<double>(points_m.size());
}

/// The largest distance from corner to corner.
double extent_m(const Polygon& polygon) {
  double max_m = 0.0;
  for (const Eigen::Vector2d& one_m : polygon) {
    for (const Eigen::Vector2d& other_m : polygon) {
      max_m = std::max(max_m, (one_m - other_m).norm());
    }
  }
  return max_m;
}

/// Points along an obstacle's outline whose outer side is truly free floor.
std::vector<Eigen::Vector2d> visible_points_m(const Polygon& obstacle, const RasterMap& truth) {
  const double outward = geometry::signed_area_m2(obstacle) > 0.0 ? -1.0 : 1.0;
  std::vector<Eigen::Vector2d> points_m;
  for (std::size_t i = 0; i < obstacle.size(); ++i) {
    const geometry::Segment side = geometry::side(obstacle, i);
    const Eigen::Vector2d skin_m = outward * kSkinM * geometry::left_normal(side);
    const int steps = std::max(1, static_cast<int>(std::lround(side.length_m() / kStepM)));
    for (int k = 0; k < steps; ++k) {
      const Eigen::Vector2d point_m = side.from_m + (k + 0.5) / steps * (side.to_m - side.from_m);
      if (truth.state(truth.cell_at(point_m + skin_m)) == CellState::kFree) {
        points_m.push_back(point_m);
      }
    }
  }
  return points_m;
}

using OccupiedCells = geometry::PointBuckets<Eigen::Vector2d>;

bool is_found(const std::vector<Eigen::Vector2d>& outline_m, const OccupiedCells& occupied) {
  const auto near = std::count_if(outline_m.begin(), outline_m.end(), [&](const auto& point_m) {
    bool has_cell = false;
    occupied.visit_near(point_m, [&](const Eigen::Vector2d& center_m) {
      has_cell = has_cell || (center_m - point_m).norm() <= kObjectReachM;
    });
    return has_cell;
  });
  return 2 * static_cast<std::size_t>(near) >= outline_m.size();
}

void count_objects(const std::vector<Polygon>& obstacles,
                   const OccupiedCells& occupied,
                   const RasterMap& truth,
                   ObstacleAgreement& agreement) {
  for (const Polygon& obstacle : obstacles) {
    const auto outline_m = visible_points_m(obstacle, truth);
    if (extent_m(obstacle) < kMinObjectM || outline_m.empty()) {
      continue;
    }
    ++agreement.objects;
    agreement.objects_found += is_found(outline_m, occupied) ? 1U : 0U;
  }
}

}  // namespace

ObstacleAgreement score_obstacles(const RasterMap& map,
                                  const Pose2& T_world_map,
                                  const MapTruth& truth) {
  const auto obstacles = obstacle_rings(truth.walls);
  const Pose2 T_map_world = T_world_map.inverse();
  OccupiedCells occupied(kObjectReachM);
  for (const Eigen::Vector2d& center_m : mapping::centers_m(map, CellState::kOccupied)) {
    const Eigen::Vector2d world_m = T_world_map * center_m;
    occupied.add(world_m, world_m);
  }
  ObstacleAgreement agreement;
  agreement.solid_called_free = share_called_free(map, T_map_world, inside_points_m(obstacles));
  agreement.wall_band_called_free =
      share_called_free(map, T_map_world, wall_band_points_m(first_ring(truth.walls)));
  count_objects(obstacles, occupied, truth.cells, agreement);
  return agreement;
}

}  // namespace echomap::evaluation
