// SPDX-License-Identifier: MIT
#include "host/papers/epuck_grid_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "host/geometry/polygon.hpp"
#include "host/papers/epuck_field.hpp"
#include "host/papers/room_floor.hpp"

namespace echomap::papers {
namespace {

using geometry::CellIndex;
using mapping::CellState;
using mapping::RasterMap;

constexpr double kFoundWithinM = 0.003;
constexpr double kAboutWithinM = 0.01;
constexpr double kNearM = 0.005;
/// Walls are sampled in steps of this size.
constexpr double kWallStepM = 0.001;

template <typename Visitor>
void for_cells(const RasterMap& map, Visitor&& visit) {
  for (CellIndex cell{0, 0}; cell.y < map.rows(); ++cell.y) {
    for (cell.x = 0; cell.x < map.columns(); ++cell.x) {
      visit(cell, map.center_m(cell));
    }
  }
}

/// Whether a point is on the true floor, to a millimetre.
bool is_true_floor(const Eigen::Vector2d& point_m) {
  static const RasterMap floor = floor_of(epuck_field(), 0.001, 0.0);
  return floor.state(floor.cell_at(point_m)) == CellState::kFree;
}

bool occupied_within(const RasterMap& map, const Eigen::Vector2d& point_m, double reach_m) {
  const CellIndex low = map.cell_at(point_m.array() - reach_m);
  const CellIndex high = map.cell_at(point_m.array() + reach_m);
  for (CellIndex cell = low; cell.y <= high.y; ++cell.y) {
    for (cell.x = low.x; cell.x <= high.x; ++cell.x) {
      if (map.state(cell) == CellState::kOccupied &&
          (map.center_m(cell) - point_m).norm() <= reach_m) {
        return true;
      }
    }
  }
  return false;
}

/// Share of the walls' length with an occupied cell within that distance.
double walls_within(const RasterMap& map, double reach_m) {
  int points = 0;
  int found = 0;
  for (const world::Wall& wall : epuck_field().walls()) {
    const Eigen::Vector2d offset_m = wall.segment.to_m - wall.segment.from_m;
    const int steps = static_cast<int>(std::lround(offset_m.norm() / kWallStepM));
    for (int i = 0; i < steps; ++i) {
      ++points;
      found += occupied_within(map, wall.segment.from_m + (i + 0.5) / steps * offset_m, reach_m);
    }
  }
  return static_cast<double>(found) / points;
}

void add_occupied(const RasterMap& map, EpuckGridFigures& figures) {
  std::vector<double> distances_m;
  double squares = 0.0;
  for (const Eigen::Vector2d& center_m : mapping::centers_m(map, CellState::kOccupied)) {
    distances_m.push_back(epuck_field().clearance_m(center_m));
    squares += distances_m.back() * distances_m.back();
  }
  if (distances_m.empty()) {
    return;
  }
  std::sort(distances_m.begin(), distances_m.end());
  const auto near = std::upper_bound(distances_m.begin(), distances_m.end(), kNearM);
  const auto count = static_cast<double>(distances_m.size());
  figures.occupied_near = static_cast<double>(near - distances_m.begin()) / count;
  figures.occupied_rms_m = std::sqrt(squares / count);
  figures.occupied_median_m = distances_m[distances_m.size() / 2];
}

void add_free(const RasterMap& map, EpuckGridFigures& figures) {
  double floor = 0.0;
  double called = 0.0;
  double both = 0.0;
  for_cells(map, [&](CellIndex cell, const Eigen::Vector2d& center_m) {
    const CellState state = map.state(cell);
    const bool inside = is_true_floor(center_m);
    floor += inside;
    called += state == CellState::kFree;
    both += inside && state == CellState::kFree;
    if (!inside && state != CellState::kUnknown) {
      figures.deepest_m = std::max(figures.deepest_m, epuck_field().clearance_m(center_m));
    }
  });
  figures.free_found = floor > 0.0 ? both / floor : 0.0;
  figures.free_wrong = called > 0.0 ? 1.0 - both / called : 0.0;
}

double blocks_unknown(const RasterMap& map) {
  double inside = 0.0;
  double unknown = 0.0;
  for_cells(map, [&](CellIndex cell, const Eigen::Vector2d& center_m) {
    const auto& blocks_m = epuck_field().obstacles_m();
    if (std::any_of(blocks_m.begin(), blocks_m.end(), [&](const geometry::Polygon& block_m) {
          return geometry::contains(block_m, center_m);
        })) {
      ++inside;
      unknown += map.state(cell) == CellState::kUnknown;
    }
  });
  return inside > 0.0 ? unknown / inside : 0.0;
}

/// Marks the unknown clot around a cell as seen and returns its cells.
std::vector<CellIndex> take_clot(RasterMap& unseen, CellIndex first) {
  std::vector<CellIndex> clot;
  const auto take = [&](CellIndex cell) {
    if (unseen.contains(cell) && unseen.state(cell) == CellState::kUnknown) {
      unseen.set(cell, CellState::kFree);
      clot.push_back(cell);
    }
  };
  take(first);
  for (std::size_t i = 0; i < clot.size(); ++i) {
    const CellIndex cell = clot[i];
    take({cell.x - 1, cell.y});
    take({cell.x + 1, cell.y});
    take({cell.x, cell.y - 1});
    take({cell.x, cell.y + 1});
  }
  return clot;
}

}  // namespace

EpuckGridFigures epuck_grid_figures(const RasterMap& map) {
  EpuckGridFigures figures;
  figures.walls_found = walls_within(map, kFoundWithinM);
  figures.walls_about = walls_within(map, kAboutWithinM);
  figures.blocks_unknown = blocks_unknown(map);
  add_occupied(map, figures);
  add_free(map, figures);
  return figures;
}

RasterMap without_small_clots(RasterMap map) {
  const double robot_m2 = std::numbers::pi * kEpuckRadiusM * kEpuckRadiusM;
  const auto robot_cells = static_cast<std::size_t>(robot_m2 / std::pow(map.resolution_m(), 2));
  RasterMap unseen = map;
  for_cells(map, [&](CellIndex first, const Eigen::Vector2d&) {
    const std::vector<CellIndex> clot = take_clot(unseen, first);
    if (clot.size() < robot_cells) {
      for (const CellIndex cell : clot) {
        map.set(cell, CellState::kFree);
      }
    }
  });
  return map;
}

}  // namespace echomap::papers
