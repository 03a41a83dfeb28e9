// SPDX-License-Identifier: MIT
#include "host/evaluation/map_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "host/geometry/unit_vector.hpp"

namespace echomap::evaluation {

namespace {

using geometry::CellIndex;
using geometry::Pose2;
using mapping::CellState;
using mapping::RasterMap;

constexpr double kRecallReachM = 0.05;
/// A room of 100 m x 100 m at a centimetre; more is a map that lies somewhere else.
constexpr double kMaxCells = 1e8;
constexpr double kWallStepM = 0.01;
/// Free cells of the truth begin beside a wall, at most this far from it.
constexpr double kWallSkinM = 0.03;

/// The true state of the floor under the centre of a map cell.
CellState true_state(const RasterMap& map,
                     CellIndex cell,
                     const Pose2& T_world_map,
                     const RasterMap& truth) {
  return truth.state(truth.cell_at(T_world_map * map.center_m(cell)));
}

double free_iou(const RasterMap& map, const Pose2& T_world_map, const RasterMap& truth) {
  const auto cells = cells_of_both(map, T_world_map, truth);
  int common = 0;
  int either = 0;
  for (int y = cells.min.y; y <= cells.max.y; ++y) {
    for (int x = cells.min.x; x <= cells.max.x; ++x) {
      const bool said = map.state({x, y}) == CellState::kFree;
      const bool is = true_state(map, {x, y}, T_world_map, truth) == CellState::kFree;
      common += said && is ? 1 : 0;
      either += said || is ? 1 : 0;
    }
  }
  return either == 0 ? 1.0 : static_cast<double>(common) / either;
}

/// The same in the world frame.
std::vector<Eigen::Vector2d> in_the_world_m(std::vector<Eigen::Vector2d> points_m,
                                            const Pose2& T_world_map) {
  for (Eigen::Vector2d& point_m : points_m) {
    point_m = T_world_map * point_m;
  }
  return points_m;
}

std::optional<double> wall_rmse_m(const std::vector<Eigen::Vector2d>& centers_m,
                                  const std::vector<geometry::Segment>& walls) {
  if (centers_m.empty() || walls.empty()) {
    return std::nullopt;
  }
  double squares_m2 = 0.0;
  for (const auto& center_m : centers_m) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const auto& wall : walls) {
      nearest_m = std::min(nearest_m, geometry::distance_m(wall, center_m));
    }
    squares_m2 += nearest_m * nearest_m;
  }
  return std::sqrt(squares_m2 / static_cast<double>(centers_m.size()));
}

/// Points along the walls, a centimetre apart, that border on truly free floor.
std::vector<Eigen::Vector2d> visible_wall_points_m(const MapTruth& truth) {
  std::vector<Eigen::Vector2d> points_m;
  for (const auto& wall : truth.walls) {
    const Eigen::Vector2d along = (wall.to_m - wall.from_m).normalized();
    const Eigen::Vector2d skin_m = kWallSkinM * geometry::perpendicular(along);
    const int steps = static_cast<int>(std::lround(wall.length_m() / kWallStepM));
    for (int i = 0; i < steps; ++i) {
      const Eigen::Vector2d point_m = wall.from_m + (i + 0.5) * kWallStepM * along;
      const bool visible =
          truth.cells.state(truth.cells.cell_at(point_m + skin_m)) == CellState::kFree ||
          truth.cells.state(truth.cells.cell_at(point_m - skin_m)) == CellState::kFree;
      if (visible) {
        points_m.push_back(point_m);
      }
    }
  }
  return points_m;
}

double wall_recall(const std::vector<Eigen::Vector2d>& centers_m,
                   double reach_m,
                   const MapTruth& truth) {
  const auto points_m = visible_wall_points_m(truth);
  const auto found = std::count_if(points_m.begin(), points_m.end(), [&](const auto& point_m) {
    return std::any_of(centers_m.begin(), centers_m.end(), [&](const auto& center_m) {
      return (center_m - point_m).norm() <= reach_m;
    });
  });
  return points_m.empty() ? 1.0 : static_cast<double>(found) / static_cast<double>(points_m.size());
}

}  // namespace

mapping::CellBounds cells_of_both(const RasterMap& map,
                                  const Pose2& T_world_map,
                                  const RasterMap& truth) {
  mapping::CellBounds cells{{0, 0}, {map.columns() - 1, map.rows() - 1}};
  const Pose2 T_map_world = T_world_map.inverse();
  for (const CellIndex corner : {CellIndex{0, 0},
                                 CellIndex{truth.columns(), 0},
                                 CellIndex{0, truth.rows()},
                                 CellIndex{truth.columns(), truth.rows()}}) {
    const Eigen::Vector2d corner_m =
        truth.origin_m() + truth.resolution_m() * Eigen::Vector2d(corner.x, corner.y);
    const CellIndex cell = map.cell_at(T_map_world * corner_m);
    cells.min = {std::min(cells.min.x, cell.x), std::min(cells.min.y, cell.y)};
    cells.max = {std::max(cells.max.x, cell.x), std::max(cells.max.y, cell.y)};
  }
  if (static_cast<double>(cells.columns()) * cells.rows() > kMaxCells) {
    throw std::invalid_argument("the map lies too far from the truth to be compared with it");
  }
  return cells;
}

double wall_reach_m(const RasterMap& map) { return std::max(kRecallReachM, map.resolution_m()); }

MapAgreement score_map(const RasterMap& map, const Pose2& T_world_map, const MapTruth& truth) {
  const auto centers_m = in_the_world_m(mapping::centers_m(map, CellState::kOccupied), T_world_map);
  MapAgreement agreement;
  agreement.free_iou = free_iou(map, T_world_map, truth.cells);
  agreement.wall_rmse_m = wall_rmse_m(centers_m, truth.walls);
  agreement.wall_recall = wall_recall(centers_m, wall_reach_m(map), truth);
  return agreement;
}

}  // namespace echomap::evaluation
