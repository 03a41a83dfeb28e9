// SPDX-License-Identifier: MIT
#include "host/source_search/solid_lengths.hpp"

#include <algorithm>
#include <cmath>

namespace echomap::source_search {

namespace {

/// How far a line is followed without a look, at most.
constexpr double kMaxClearM = 2.0;
/// Beside and in what is solid a line is followed in steps of so much of a cell.
constexpr float kFineStepCells = 0.25F;
/// A cell that is d cells from the nearest occupied one has so much less of clear way around any of
/// its points.
constexpr float kTwoHalfDiagonals = 1.4143F;

}  // namespace

SolidLengths::SolidLengths(const mapping::RasterMap& map) : field_(map, kMaxClearM) {}

double SolidLengths::between_m(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const {
  const double per_cell = 1.0 / field_.resolution_m();
  const Eigen::Vector2f from = ((from_m - field_.origin_m()) * per_cell).cast<float>();
  const Eigen::Vector2f line = ((to_m - from_m) * per_cell).cast<float>();
  const float length = line.norm();
  if (length <= 0.0F) {
    return 0.0;
  }
  const Eigen::Vector2f direction = line / length;
  float solid = 0.0F;
  float step = 0.0F;
  for (float at = 0.0F; at < length; at += step) {
    const Eigen::Vector2f point = from + (at + 0.5F * kFineStepCells) * direction;
    const auto x = static_cast<std::int32_t>(std::floor(point.x()));
    const auto y = static_cast<std::int32_t>(std::floor(point.y()));
    const bool is_inside = x >= 0 && y >= 0 && x < field_.columns() && y < field_.rows();
    const float clear = is_inside ? field_.distance_cells({x, y}) : kTwoHalfDiagonals;
    step = std::min(std::max(kFineStepCells, clear - kTwoHalfDiagonals), length - at);
    solid += clear == 0.0F ? step : 0.0F;
  }
  return static_cast<double>(solid) * field_.resolution_m();
}

}  // namespace echomap::source_search
