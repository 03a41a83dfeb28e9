// SPDX-License-Identifier: MIT
#include "host/exploration/cost_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/distance_field.hpp"

namespace echomap::exploration {

namespace {

using geometry::CellIndex;
using mapping::CellState;
using mapping::DistanceField;
using mapping::RasterMap;

constexpr double kDearestAllowed = 30.0;

void validate(const CostGridParams& params) {
  geometry::ParameterValidator("cost grid")
      .positive("robot_radius_m", params.robot_radius_m)
      .at_least("clearance_m", params.clearance_m, 0.0)
      .at_least("wary_m", params.wary_m, 0.0)
      .at_least("standing_m", params.standing_m, 0.0)
      .within("dearest", params.dearest, 1.0, kDearestAllowed);
}

/// Free floor so few cells off in this direction, and nothing occupied before it.
bool has_free_floor(const RasterMap& map, CellIndex cell, std::int32_t dx, std::int32_t dy) {
  constexpr int kWidest = 3;
  for (int i = 1; i <= kWidest; ++i) {
    const CellState state = map.state({cell.x + i * dx, cell.y + i * dy});
    if (state != CellState::kUnknown) {
      return state == CellState::kFree;
    }
  }
  return false;
}

/// Free floor lies to both sides.
bool is_ford(const RasterMap& map, CellIndex cell) {
  constexpr std::array<CellIndex, 4> kDirections{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  return std::any_of(kDirections.begin(), kDirections.end(), [&](CellIndex direction) {
    return has_free_floor(map, cell, direction.x, direction.y) &&
           has_free_floor(map, cell, -direction.x, -direction.y);
  });
}

/// The map with fords as free floor, and with all other unknown floor as `unknown_is`.
RasterMap redrawn(const RasterMap& map, CellState unknown_is) {
  RasterMap drawn = map;
  for (int y = 0; y < map.rows(); ++y) {
    const CellState* states = map.row(y);
    for (int x = 0; x < map.columns(); ++x) {
      if (states[x] == CellState::kUnknown) {
        drawn.set({x, y}, is_ford(map, {x, y}) ? CellState::kFree : unknown_is);
      }
    }
  }
  return drawn;
}

}  // namespace

CostGrid::CostGrid(const RasterMap& map,
                   const Eigen::Vector2d& here_m,
                   const CostGridParams& params)
    : columns_(map.columns()),
      rows_(map.rows()),
      resolution_m_(map.resolution_m()),
      origin_m_(map.origin_m()),
      costs_(static_cast<std::size_t>(map.columns() + 2) *
             static_cast<std::size_t>(map.rows() + 2)) {
  validate(params);
  inflate(map, params);
  open_around(map, cell_at(here_m), params.standing_m, params);
}

void CostGrid::open_along(const RasterMap& map,
                          const std::vector<Eigen::Vector2d>& been_m,
                          double reach_m,
                          const CostGridParams& params) {
  CellIndex last{-1, -1};
  for (const Eigen::Vector2d& place_m : been_m) {
    const CellIndex cell = cell_at(place_m);
    if (cell != last) {
      open_around(map, cell, reach_m, params);
      last = cell;
    }
  }
}

template <class Change>
void CostGrid::change_around(const Eigen::Vector2d& at_m, double radius_m, Change change) {
  const CellIndex low = cell_at(at_m.array() - radius_m);
  const CellIndex high = cell_at(at_m.array() + radius_m);
  for (std::int32_t y = std::max(low.y, 0); y <= std::min(high.y, rows_ - 1); ++y) {
    for (std::int32_t x = std::max(low.x, 0); x <= std::min(high.x, columns_ - 1); ++x) {
      if (is_open({x, y}) && (center_m({x, y}) - at_m).norm() <= radius_m) {
        change(costs_[index({x, y})]);
      }
    }
  }
}

void CostGrid::raise_around(const Eigen::Vector2d& at_m, double radius_m, double factor) {
  const auto least = static_cast<std::uint8_t>(kPlain * factor);
  change_around(at_m, radius_m, [&](std::uint8_t& cost) { cost = std::max(cost, least); });
}

void CostGrid::close_around(const Eigen::Vector2d& at_m, double radius_m) {
  change_around(at_m, radius_m, [](std::uint8_t& cost) { cost = 0; });
}

CellIndex CostGrid::cell_at(const Eigen::Vector2d& point_m) const {
  const Eigen::Vector2d cells = (point_m - origin_m_) / resolution_m_;
  constexpr double kFar = 1 << 30;
  return {static_cast<std::int32_t>(std::floor(std::clamp(cells.x(), -kFar, kFar))),
          static_cast<std::int32_t>(std::floor(std::clamp(cells.y(), -kFar, kFar)))};
}

Eigen::Vector2d CostGrid::center_m(CellIndex cell) const {
  return origin_m_ + resolution_m_ * Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5);
}

void CostGrid::inflate(const RasterMap& map, const CostGridParams& params) {
  const double closed_cells = (params.robot_radius_m + params.clearance_m) / resolution_m_;
  const double wary_cells = params.wary_m / resolution_m_;
  const RasterMap not_free = redrawn(map, CellState::kOccupied);
  const DistanceField to_occupied(map, resolution_m_ * (closed_cells + 1.0));
  const DistanceField to_not_free(not_free, resolution_m_ * (closed_cells + wary_cells + 1.0));
  for (int y = 0; y < rows_; ++y) {
    const CellState* states = not_free.row(y);
    const float* occupied_cells = to_occupied.row(y);
    const float* not_free_cells = to_not_free.row(y);
    std::uint8_t* costs = &costs_[index({0, y})];
    for (int x = 0; x < columns_; ++x) {
      if (states[x] != CellState::kFree || static_cast<double>(occupied_cells[x]) < closed_cells) {
        continue;
      }
      const double beyond_cells = static_cast<double>(not_free_cells[x]) - closed_cells;
      const double nearness =
          wary_cells > 0.0 ? std::clamp(1.0 - beyond_cells / wary_cells, 0.0, 1.0) : 0.0;
      costs[x] = static_cast<std::uint8_t>(kPlain * (1.0 + nearness * (params.dearest - 1.0)));
    }
  }
}

void CostGrid::open_around(const RasterMap& map,
                           CellIndex middle,
                           double reach_m,
                           const CostGridParams& params) {
  const auto reach = static_cast<std::int32_t>(reach_m / resolution_m_);
  for (std::int32_t dy = -reach; dy <= reach; ++dy) {
    for (std::int32_t dx = -reach; dx <= reach; ++dx) {
      const CellIndex cell{middle.x + dx, middle.y + dy};
      const bool is_near = dx * dx + dy * dy <= reach * reach;
      if (is_near && contains(cell) && costs_[index(cell)] == 0 &&
          map.state(cell) != CellState::kOccupied) {
        costs_[index(cell)] = static_cast<std::uint8_t>(kPlain * params.dearest);
      }
    }
  }
}

}  // namespace echomap::exploration
