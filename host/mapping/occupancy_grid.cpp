// SPDX-License-Identifier: MIT
#include "host/mapping/occupancy_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace echomap::mapping {

namespace {

using geometry::CellIndex;

int to_centilogits(double probability) {
  return static_cast<int>(std::lround(100.0 * std::log(probability / (1.0 - probability))));
}

bool contains(const CellBounds& bounds, CellIndex cell) {
  return cell.x >= bounds.min.x && cell.x <= bounds.max.x && cell.y >= bounds.min.y &&
         cell.y <= bounds.max.y;
}

CellBounds extended(const CellBounds& bounds, CellIndex cell) {
  if (bounds.empty()) {
    return {cell, cell};
  }
  return {{std::min(bounds.min.x, cell.x), std::min(bounds.min.y, cell.y)},
          {std::max(bounds.max.x, cell.x), std::max(bounds.max.y, cell.y)}};
}

std::size_t index_in(const CellBounds& bounds, CellIndex cell) {
  return static_cast<std::size_t>(cell.y - bounds.min.y) *
             static_cast<std::size_t>(bounds.columns()) +
         static_cast<std::size_t>(cell.x - bounds.min.x);
}

}  // namespace

OccupancyGrid::OccupancyGrid(const OccupancyGridParams& params) : params_(params) {
  const bool thresholds_ordered = params.free_threshold > 0.0 &&
                                  params.free_threshold < params.occupied_threshold &&
                                  params.occupied_threshold < 1.0;
  if (!(params.resolution_m > 0.0) || params.clamp_centilogits <= 0 || !thresholds_ordered) {
    throw std::invalid_argument(
        "an occupancy grid needs a resolution and a clamp above 0 and thresholds with "
        "0 < free < occupied < 1");
  }
  free_centilogits_ = to_centilogits(params.free_threshold);
  occupied_centilogits_ = to_centilogits(params.occupied_threshold);
}

CellIndex OccupancyGrid::cell_at(const Eigen::Vector2d& point_m) const {
  return {static_cast<std::int32_t>(std::floor(point_m.x() / params_.resolution_m)),
          static_cast<std::int32_t>(std::floor(point_m.y() / params_.resolution_m))};
}

Eigen::Vector2d OccupancyGrid::center_m(CellIndex cell) const {
  return {(cell.x + 0.5) * params_.resolution_m, (cell.y + 0.5) * params_.resolution_m};
}

void OccupancyGrid::add(CellIndex cell, int centilogits) {
  if (centilogits == 0) {
    return;
  }
  std::int16_t& stored = touch(cell);
  const int before = stored == kUntouched ? 0 : stored;
  const int limit = params_.clamp_centilogits;
  stored = static_cast<std::int16_t>(std::clamp(before + centilogits, -limit, limit));
}

std::optional<int> OccupancyGrid::centilogits(CellIndex cell) const {
  const std::int16_t* stored = find(cell);
  if (stored == nullptr || *stored == kUntouched) {
    return std::nullopt;
  }
  return *stored;
}

std::optional<double> OccupancyGrid::probability(CellIndex cell) const {
  const auto evidence = centilogits(cell);
  if (!evidence) {
    return std::nullopt;
  }
  return 1.0 / (1.0 + std::exp(-*evidence / 100.0));
}

CellState OccupancyGrid::state(CellIndex cell) const {
  const auto evidence = centilogits(cell);
  if (evidence && *evidence <= free_centilogits_) {
    return CellState::kFree;
  }
  if (evidence && *evidence >= occupied_centilogits_) {
    return CellState::kOccupied;
  }
  return CellState::kUnknown;
}

const std::int16_t* OccupancyGrid::find(CellIndex cell) const {
  const CellIndex tile{cell.x >> kTileBits, cell.y >> kTileBits};
  if (!contains(tile_bounds_, tile)) {
    return nullptr;
  }
  const std::int32_t entry = tile_table_[index_in(tile_bounds_, tile)];
  if (entry < 0) {
    return nullptr;
  }
  const auto column = static_cast<std::size_t>(cell.x & (kTileSide - 1));
  const auto row = static_cast<std::size_t>(cell.y & (kTileSide - 1));
  return &tiles_[static_cast<std::size_t>(entry)][(row << kTileBits) + column];
}

std::int16_t& OccupancyGrid::touch(CellIndex cell) {
  bounds_ = extended(bounds_, cell);
  const CellIndex tile{cell.x >> kTileBits, cell.y >> kTileBits};
  grow_table_to(tile);
  std::int32_t& entry = tile_table_[index_in(tile_bounds_, tile)];
  if (entry < 0) {
    entry = static_cast<std::int32_t>(tiles_.size());
    tiles_.emplace_back().fill(kUntouched);
  }
  return const_cast<std::int16_t&>(*find(cell));
}

void OccupancyGrid::grow_table_to(CellIndex tile) {
  if (contains(tile_bounds_, tile)) {
    return;
  }
  const CellBounds grown = extended(tile_bounds_, tile);
  std::vector<std::int32_t> table(
      static_cast<std::size_t>(grown.columns()) * static_cast<std::size_t>(grown.rows()), -1);
  for (std::size_t i = 0; i < tile_table_.size(); ++i) {
    const auto columns = static_cast<std::size_t>(tile_bounds_.columns());
    const CellIndex moved{tile_bounds_.min.x + static_cast<std::int32_t>(i % columns),
                          tile_bounds_.min.y + static_cast<std::int32_t>(i / columns)};
    table[index_in(grown, moved)] = tile_table_[i];
  }
  tile_table_ = std::move(table);
  tile_bounds_ = grown;
}

double newly_free_area_m2(const OccupancyGrid& before, const OccupancyGrid& now) {
  const CellBounds& bounds = now.bounds();
  int cells = 0;
  for (std::int32_t y = bounds.min.y; y <= bounds.max.y; ++y) {
    for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
      const bool is_new =
          now.state({x, y}) == CellState::kFree && before.state({x, y}) == CellState::kUnknown;
      cells += is_new ? 1 : 0;
    }
  }
  return cells * now.resolution_m() * now.resolution_m();
}

}  // namespace echomap::mapping
