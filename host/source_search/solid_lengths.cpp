// SPDX-License-Identifier: MIT
#include "host/source_search/solid_lengths.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace echomap::source_search {

using exploration::CellValues;
using exploration::for_each_cell;
using geometry::CellIndex;
using mapping::CellState;

namespace {

/// How far a line is followed without a look, at most.
constexpr double kMaxClearM = 2.0;
/// Beside and in what is solid a line is followed in steps of so much of a cell.
constexpr float kFineStepCells = 0.5F;
/// A cell that is d cells from the nearest occupied one has so much less of clear way around any of
/// its points.
constexpr float kTwoHalfDiagonals = 1.4143F;
/// What is less likely solid than this is air.
constexpr float kMinSolidShare = 0.02F;

CellValues<float> unknown_solids(const mapping::RasterMap& map,
                                 const CellValues<float>& floor_chance) {
  CellValues<float> solids(map, 0.0F);
  for_each_cell(map, [&](CellIndex cell) {
    const float share = 1.0F - floor_chance[cell];
    const bool is_unknown = map.state(cell) == CellState::kUnknown;
    solids[cell] = is_unknown && share >= kMinSolidShare ? share : 0.0F;
  });
  return solids;
}

/// With obstacles where it is solid or may be.
mapping::RasterMap matter_of(const mapping::RasterMap& map, const CellValues<float>& unknown) {
  mapping::RasterMap matter = map;
  for_each_cell(map, [&](CellIndex cell) {
    if (unknown[cell] > 0.0F) {
      matter.set(cell, CellState::kOccupied);
    }
  });
  return matter;
}

}  // namespace

SolidLengths::SolidLengths(const mapping::RasterMap& map,
                           const CellValues<float>& floor_chance,
                           double hollow_m)
    : hollow_m_(hollow_m),
      unknown_(unknown_solids(map, floor_chance)),
      field_(matter_of(map, unknown_), kMaxClearM) {
  for_each_cell(map, [&](CellIndex cell) { has_unknown_ = has_unknown_ || unknown_[cell] > 0.0F; });
}

CrossedLengths SolidLengths::between(const Eigen::Vector2d& sensor_m,
                                     const Eigen::Vector2d& source_m) const {
  const double per_cell = 1.0 / field_.resolution_m();
  const Eigen::Vector2f from = ((source_m - field_.origin_m()) * per_cell).cast<float>();
  const Eigen::Vector2f line = ((sensor_m - source_m) * per_cell).cast<float>();
  const float length = line.norm();
  if (length <= 0.0F) {
    return {};
  }
  const Eigen::Vector2f direction = line / length;
  const auto columns = static_cast<float>(field_.columns());
  const auto rows = static_cast<float>(field_.rows());
  const auto hollow = static_cast<float>(hollow_m_ * per_cell);
  float solid = 0.0F;
  float unknown = 0.0F;
  float step = 0.0F;
  bool is_in_hollow = true;
  for (float at = 0.0F; at < length; at += step) {
    const float middle = at + 0.5F * kFineStepCells;
    const float x = from.x() + middle * direction.x();
    const float y = from.y() + middle * direction.y();
    const bool is_inside = x >= 0.0F && y >= 0.0F && x < columns && y < rows;
    const CellIndex cell{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    const float clear = is_inside ? field_.distance_cells(cell) : kTwoHalfDiagonals;
    step = std::min(std::max(kFineStepCells, clear - kTwoHalfDiagonals), length - at);
    const float share = clear == 0.0F ? unknown_[cell] : 0.0F;
    is_in_hollow = is_in_hollow && share > 0.0F && at < hollow;
    solid += clear == 0.0F && share == 0.0F ? step : 0.0F;
    unknown += is_in_hollow ? 0.0F : step * share;
  }
  return {static_cast<double>(solid) * field_.resolution_m(),
          static_cast<double>(unknown) * field_.resolution_m()};
}

/// Along the axis of the cone, which widens towards the disc and ends behind it.
bool SolidLengths::is_clear(const Eigen::Vector2d& from_m,
                            const Eigen::Vector2d& middle_m,
                            double radius_m) const {
  const double length_m = (middle_m - from_m).norm();
  const double wide_from_m = std::max(length_m, 1e-6);
  const Eigen::Vector2d direction = (middle_m - from_m) / wide_from_m;
  double step_m = 0.0;
  for (double at_m = 0.0; at_m <= length_m; at_m += step_m) {
    const double clear_m = clearance_m(from_m + at_m * direction);
    const double slope = radius_m / wide_from_m;
    const double half_width_m = slope * at_m;
    step_m = (clear_m - half_width_m) / (1.0 + slope);
    if (step_m < 0.5 * field_.resolution_m()) {
      return false;
    }
  }
  return clearance_m(middle_m) > radius_m;
}

double SolidLengths::clearance_m(const Eigen::Vector2d& at_m) const {
  const Eigen::Vector2d point = (at_m - field_.origin_m()) / field_.resolution_m();
  const auto x = static_cast<std::int32_t>(std::floor(point.x()));
  const auto y = static_cast<std::int32_t>(std::floor(point.y()));
  const bool is_inside = x >= 0 && y >= 0 && x < field_.columns() && y < field_.rows();
  return is_inside ? static_cast<double>(field_.distance_cells({x, y}) - kTwoHalfDiagonals) *
                         field_.resolution_m()
                   : 0.0;
}

}  // namespace echomap::source_search
