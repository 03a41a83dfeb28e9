// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace echomap::mapping {

/// The cells of one row of a sector, columns `first` to `last` as seen from the apex cell, and
/// where their steps begin; without cells, `last` is before `first`.
struct SectorRow {
  std::int16_t first = 0;
  std::int16_t last = -1;
  std::uint32_t steps_begin = 0;
};

/// From the least to the greatest share of a range that lies along an axis.
struct ShareRange {
  double least = 0.0;
  double greatest = 0.0;
};

/// A sector that faces one way: rows from `first_row` upwards, as seen from the apex cell.
struct FacingSector {
  std::int32_t first_row = 0;
  std::vector<SectorRow> rows;
  /// With kTileSide bytes before and after that may be read, though not used.
  std::vector<std::uint8_t> steps;
  /// The cosines and sines of the bearings in the sector.
  ShareRange along_x;
  ShareRange along_y;
};

/// Evidence by the angle off axis, laid out on cells around an apex in the middle of its own, once
/// for each of 360 bearings and only when one is first asked for.
class ConeSector {
 public:
  static constexpr std::size_t kBearings = 360;

  /// `steps_by_angle` are for equal parts of the half opening from the axis outwards, none of them
  /// 0; half opening in (0, pi / 2), radius at most 2000 cells.
  ConeSector(std::vector<std::uint8_t> steps_by_angle,
             double half_opening_rad,
             std::int32_t radius_cells);

  bool empty() const { return steps_by_angle_.empty(); }
  /// `bearing` in whole degrees, 0 to 359; the sector must not be empty.
  const FacingSector& facing(std::size_t bearing);

 private:
  FacingSector lay_out(double axis_rad) const;
  std::uint8_t steps_at(const Eigen::Vector2d& from_apex, const Eigen::Vector2d& axis) const;

  std::vector<std::uint8_t> steps_by_angle_;
  double half_opening_rad_;
  std::int32_t radius_cells_;
  std::vector<FacingSector> facing_ = std::vector<FacingSector>(kBearings);
};

}  // namespace echomap::mapping
