// SPDX-License-Identifier: MIT
#include "hil_mock/runner/truth_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace echomap::runner {
namespace {

constexpr double kMarginM = 0.1;
/// Sizes that are whole numbers of cells but for rounding stay whole.
constexpr double kRounding = 1e-6;

Eigen::Vector2d centre_m(const TruthMap& map, int column, int row) {
  return {map.origin_x_m + (column + 0.5) * map.resolution_m,
          map.origin_y_m + (row + 0.5) * map.resolution_m};
}

std::size_t index(const TruthMap& map, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) +
         static_cast<std::size_t>(column);
}

TruthMap empty_map_around(const world::Polygon& room_m, double resolution_m) {
  Eigen::Vector2d min_m = room_m.front();
  Eigen::Vector2d max_m = room_m.front();
  for (const Eigen::Vector2d& corner_m : room_m) {
    min_m = min_m.cwiseMin(corner_m);
    max_m = max_m.cwiseMax(corner_m);
  }
  const Eigen::Vector2d cells =
      (max_m - min_m + Eigen::Vector2d::Constant(2.0 * kMarginM)) / resolution_m;
  TruthMap map;
  map.resolution_m = resolution_m;
  map.width = static_cast<int>(std::ceil(cells.x() - kRounding));
  map.height = static_cast<int>(std::ceil(cells.y() - kRounding));
  map.origin_x_m = min_m.x() - kMarginM;
  map.origin_y_m = min_m.y() - kMarginM;
  map.cells.assign(index(map, 0, map.height), TruthCell::kUnknown);
  return map;
}

/// Calls `visit` with each cell, and its centre, that has a point of a box in or beside it.
template <class Visit>
void visit_cells(TruthMap& map, const Eigen::AlignedBox2d& box, Visit visit) {
  const auto cell_of = [&](double from_origin_m, int size) {
    return std::clamp(static_cast<int>(std::floor(from_origin_m / map.resolution_m)), 0, size - 1);
  };
  const int first_row = cell_of(box.min().y() - map.origin_y_m - map.resolution_m, map.height);
  const int last_row = cell_of(box.max().y() - map.origin_y_m + map.resolution_m, map.height);
  const int first_column = cell_of(box.min().x() - map.origin_x_m - map.resolution_m, map.width);
  const int last_column = cell_of(box.max().x() - map.origin_x_m + map.resolution_m, map.width);
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      visit(map.cells[index(map, column, row)], centre_m(map, column, row));
    }
  }
}

/// Whether what is so far from the middle of a cell is drawn there.
bool is_drawn_at(const TruthMap& map, double distance_m) {
  return distance_m <= 0.5 * map.resolution_m + 1e-9;
}

void draw_walls(const world::FloorPlan& plan, TruthMap& map) {
  for (const world::Wall& wall : plan.first_walls()) {
    Eigen::AlignedBox2d around(wall.segment.from_m);
    around.extend(wall.segment.to_m);
    visit_cells(map, around, [&](TruthCell& cell, const Eigen::Vector2d& middle_m) {
      if (is_drawn_at(map, (nearest_point(wall.segment, middle_m) - middle_m).norm())) {
        cell = TruthCell::kOccupied;
      }
    });
  }
}

/// Boxes stand on what was free.
void draw_boxes(const world::FloorPlan& plan, TruthMap& map) {
  for (const world::Polygon& box_m : plan.boxes_m()) {
    Eigen::AlignedBox2d around;
    for (const Eigen::Vector2d& corner_m : box_m) {
      around.extend(corner_m);
    }
    visit_cells(map, around, [&](TruthCell& cell, const Eigen::Vector2d& middle_m) {
      if (cell != TruthCell::kFree) {
        return;
      }
      if (is_drawn_at(map, geometry::distance_to_sides_m(box_m, middle_m))) {
        cell = TruthCell::kOccupied;
      } else if (geometry::contains(box_m, middle_m)) {
        cell = TruthCell::kUnknown;
      }
    });
  }
}

/// Frees what can be reached from the start without crossing a wall or falling into a hole.
void flood_from_start(const world::FloorPlan& plan, TruthMap& map) {
  const Eigen::Vector2d start_m = plan.T_world_start().position_m();
  std::vector<std::pair<int, int>> open;
  open.emplace_back(static_cast<int>((start_m.x() - map.origin_x_m) / map.resolution_m),
                    static_cast<int>((start_m.y() - map.origin_y_m) / map.resolution_m));
  while (!open.empty()) {
    const auto [column, row] = open.back();
    open.pop_back();
    TruthCell& cell = map.cells[index(map, column, row)];
    if (cell != TruthCell::kUnknown || plan.is_hole(centre_m(map, column, row))) {
      continue;
    }
    cell = TruthCell::kFree;
    open.insert(open.end(),
                {{column - 1, row}, {column + 1, row}, {column, row - 1}, {column, row + 1}});
  }
}

}  // namespace

TruthCell TruthMap::at(int column, int row) const { return cells[index(*this, column, row)]; }

TruthMap draw_truth_map(const world::FloorPlan& plan, double resolution_m) {
  TruthMap map = empty_map_around(plan.room_m(), resolution_m);
  draw_walls(plan, map);
  flood_from_start(plan, map);
  draw_boxes(plan, map);
  return map;
}

}  // namespace echomap::runner
