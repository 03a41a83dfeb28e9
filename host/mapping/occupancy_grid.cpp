// SPDX-License-Identifier: MIT
#include "host/mapping/occupancy_grid.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/whole_cell.hpp"

namespace echomap::mapping {

namespace {

using geometry::CellIndex;

int to_centilogits(double probability) {
  return static_cast<int>(std::lround(100.0 * std::log(probability / (1.0 - probability))));
}

/// The nearest whole number of steps; halves away from zero.
int to_steps(int centilogits) {
  constexpr int kHalf = kStepCentilogits / 2;
  return (centilogits < 0 ? centilogits - kHalf : centilogits + kHalf) / kStepCentilogits;
}

CellIndex tile_of(CellIndex cell) { return {cell.x >> kTileBits, cell.y >> kTileBits}; }

}  // namespace

CellBounds united(const CellBounds& one, const CellBounds& other) {
  if (one.empty() || other.empty()) {
    return one.empty() ? other : one;
  }
  return {{std::min(one.min.x, other.min.x), std::min(one.min.y, other.min.y)},
          {std::max(one.max.x, other.max.x), std::max(one.max.y, other.max.y)}};
}

OccupancyGrid::OccupancyGrid(const OccupancyGridParams& params) : params_(params) {
  constexpr int kMaxSteps = 127;
  geometry::ParameterValidator("occupancy grid")
      .positive("resolution_m", params.resolution_m)
      .at_least("clamp_centilogits", params.clamp_centilogits, kStepCentilogits)
      .below("clamp_centilogits", params.clamp_centilogits, (kMaxSteps + 1) * kStepCentilogits)
      .positive("free_threshold", params.free_threshold)
      .above("occupied_threshold", params.occupied_threshold, params.free_threshold)
      .below("occupied_threshold", params.occupied_threshold, 1);
  const int clamp_steps = params.clamp_centilogits / kStepCentilogits;
  limits_ = {static_cast<std::uint8_t>(kEvenByte - clamp_steps),
             static_cast<std::uint8_t>(kEvenByte + clamp_steps)};
  free_centilogits_ = to_centilogits(params.free_threshold);
  occupied_centilogits_ = to_centilogits(params.occupied_threshold);
}

CellIndex OccupancyGrid::cell_at(const Eigen::Vector2d& point_m) const {
  return {geometry::whole_cell(point_m.x() / params_.resolution_m),
          geometry::whole_cell(point_m.y() / params_.resolution_m)};
}

Eigen::Vector2d OccupancyGrid::center_m(CellIndex cell) const {
  return {(cell.x + 0.5) * params_.resolution_m, (cell.y + 0.5) * params_.resolution_m};
}

void OccupancyGrid::add(CellIndex cell, int centilogits) {
  const StepPair evidence = steps(centilogits);
  if (evidence.up == evidence.down) {
    return;
  }
  begin_insertion();
  std::uint8_t& byte =
      writable_tile(tile_of(cell)).row(cell.y & (kTileSide - 1))[cell.x & (kTileSide - 1)];
  byte = after_evidence(byte, evidence, limits_);
  end_insertion({cell, cell});
}

std::optional<int> OccupancyGrid::centilogits(CellIndex cell) const {
  const std::uint8_t byte = byte_at(cell);
  if (byte == kUntouchedByte) {
    return std::nullopt;
  }
  return (byte - kEvenByte) * kStepCentilogits;
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

std::vector<CellIndex> OccupancyGrid::tiles_changed_since(std::uint64_t revision) const {
  std::vector<CellIndex> changed;
  for (const TileRecord& record : records_) {
    if (record.changed > revision) {
      changed.push_back(record.tile);
    }
  }
  return changed;
}

std::size_t OccupancyGrid::memory_bytes() const {
  return sizeof *this + index_.memory_bytes() + records_.capacity() * sizeof(TileRecord) +
         tiles_.size() * (sizeof(GridTile) + sizeof(GridTile*));
}

void OccupancyGrid::end_insertion(const CellBounds& touched) { bounds_ = united(bounds_, touched); }

GridTile& OccupancyGrid::writable_tile(CellIndex tile) {
  std::int32_t number = index_.find(tile);
  if (number == TileIndex::kNone) {
    number = static_cast<std::int32_t>(tiles_.size());
    index_.insert(tile, number);
    records_.push_back({tile, 0});
    tiles_.emplace_back();
  }
  records_[static_cast<std::size_t>(number)].changed = revision_;
  return tiles_[static_cast<std::size_t>(number)];
}

const GridTile* OccupancyGrid::find_tile(CellIndex tile) const {
  const std::int32_t number = index_.find(tile);
  return number == TileIndex::kNone ? nullptr : &tiles_[static_cast<std::size_t>(number)];
}

StepPair OccupancyGrid::steps(int centilogits) const {
  const int range = limits_.highest - limits_.lowest;
  const int whole = std::clamp(to_steps(centilogits), -range, range);
  return {static_cast<std::uint8_t>(std::max(whole, 0)),
          static_cast<std::uint8_t>(std::max(-whole, 0))};
}

std::uint8_t OccupancyGrid::byte_at(CellIndex cell) const {
  const GridTile* tile = find_tile(tile_of(cell));
  return tile == nullptr ? kUntouchedByte
                         : tile->row(cell.y & (kTileSide - 1))[cell.x & (kTileSide - 1)];
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
