// SPDX-License-Identifier: MIT
#include "tests/benchmarks/ideal_map.hpp"

#include <algorithm>
#include <cmath>

#include "hil_mock/runner/truth_map.hpp"
#include "hil_mock/world/ray_cast.hpp"

namespace echomap::bench {
namespace {

using mapping::CellState;
using mapping::RasterMap;

/// Cells of truth_map.pgm.
constexpr double kTruthCellM = 0.01;
/// A look at a wall begins so far before it.
constexpr double kSkinM = 0.001;

CellState state_of(runner::TruthCell cell) {
  switch (cell) {
    case runner::TruthCell::kFree:
      return CellState::kFree;
    case runner::TruthCell::kOccupied:
      return CellState::kOccupied;
    case runner::TruthCell::kUnknown:
      break;
  }
  return CellState::kUnknown;
}

/// Unknown cells around the room, with one more on each side.
RasterMap empty_map_around(const world::FloorPlan& plan, double cell_m) {
  const geometry::Pose2 T_map_world = plan.T_world_start().inverse();
  Eigen::Array2d low_m = T_map_world * plan.room_m().front();
  Eigen::Array2d high_m = low_m;
  for (const Eigen::Vector2d& corner_m : plan.room_m()) {
    const Eigen::Array2d on_map_m = T_map_world * corner_m;
    low_m = low_m.min(on_map_m);
    high_m = high_m.max(on_map_m);
  }
  const Eigen::Array2d first = (low_m / cell_m).floor() - 1.0;
  const Eigen::Array2d last = (high_m / cell_m).floor() + 1.0;
  return {static_cast<int>(last.x() - first.x()) + 1,
          static_cast<int>(last.y() - first.y()) + 1,
          cell_m,
          cell_m * first.matrix()};
}

/// Whether a stop shows a point; `normal` is that of a wall into the room, and zero for floor.
bool is_shown(const world::FloorPlan& plan,
              const std::vector<Eigen::Vector2d>& stops_m,
              const Eigen::Vector2d& point_m,
              const Eigen::Vector2d& normal,
              const IdealMapParams& params) {
  return std::any_of(stops_m.begin(), stops_m.end(), [&](const Eigen::Vector2d& stop_m) {
    const Eigen::Vector2d offset_m = stop_m - point_m;
    const double distance_m = offset_m.norm();
    const bool is_met =
        normal.isZero() || offset_m.dot(normal) >= distance_m * std::cos(params.max_incidence_rad);
    return distance_m <= params.reach_m && is_met &&
           (distance_m < kSkinM || world::sees(plan, point_m + kSkinM * normal, stop_m));
  });
}

}  // namespace

evaluation::MapTruth truth_of(const world::FloorPlan& plan) {
  const runner::TruthMap drawn = runner::draw_truth_map(plan, kTruthCellM);
  RasterMap cells(
      drawn.width, drawn.height, drawn.resolution_m, {drawn.origin_x_m, drawn.origin_y_m});
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 0; x < drawn.width; ++x) {
      cells.set({x, y}, state_of(drawn.at(x, y)));
    }
  }
  evaluation::MapTruth truth{std::move(cells), {}};
  for (const world::Wall& wall : plan.still_walls()) {
    truth.walls.push_back(wall.segment);
  }
  return truth;
}

RasterMap ideal_map(const world::FloorPlan& plan,
                    const evaluation::MapTruth& truth,
                    const std::vector<Eigen::Vector2d>& stops_m,
                    const IdealMapParams& params) {
  RasterMap map = empty_map_around(plan, params.cell_m);
  const geometry::Pose2& T_world_map = plan.T_world_start();
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const Eigen::Vector2d center_m = T_world_map * map.center_m({x, y});
      if (truth.cells.state(truth.cells.cell_at(center_m)) == CellState::kFree &&
          is_shown(plan, stops_m, center_m, Eigen::Vector2d::Zero(), params)) {
        map.set({x, y}, CellState::kFree);
      }
    }
  }
  const geometry::Pose2 T_map_world = T_world_map.inverse();
  for (const geometry::Segment& wall : truth.walls) {
    const Eigen::Vector2d normal = geometry::left_normal(wall);
    const int points = std::max(1, static_cast<int>(std::lround(wall.length_m() / kTruthCellM)));
    for (int i = 0; i < points; ++i) {
      const Eigen::Vector2d point_m = wall.from_m + (i + 0.5) / points * (wall.to_m - wall.from_m);
      if (is_shown(plan, stops_m, point_m, normal, params)) {
        const Eigen::Vector2d behind_m = point_m - 0.5 * params.cell_m * normal;
        map.set(map.cell_at(T_map_world * behind_m), CellState::kOccupied);
      }
    }
  }
  return map;
}

}  // namespace echomap::bench
