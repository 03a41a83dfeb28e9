// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/distance_field.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/models/range_likelihood.hpp"

namespace echomap::localization {

/// The sensor of a RangeTable.
struct RangeTableParams {
  /// Half of the sensor's cone, radians, in [0, pi / 2); 0 for a thin beam.
  double beam_half_angle_rad = 0.0;
  /// What is farther off returns nothing, metres; at most 2000 cells.
  double max_range_m = 4.0;
  /// Whether rays end where the known floor does; else they pass through unknown cells, as over a
  /// hole that nobody can drive through.
  bool ends_with_known_floor = false;
};

/// What a range sensor is to expect in each free cell of a map for each of 128 headings, as a byte:
/// the range of the nearest thing in its cone, seen from the middle of the cell, or, if that is
/// asked for and well before, of where the known floor ends along its axis. Thin rays are cast, and
/// a cone is the least of those within it. A hypothesis then costs a look-up a reading, however
/// many obstacles there are (Fox, Burgard and Thrun 1999).
///
/// Cells lie in tiles of 16 x 16, 32 KB each, which are filled when they are first asked for: a
/// robot that knows where it is pays for its surroundings only. A ring of cells without floor
/// surrounds the map.
class RangeTable {
 public:
  static constexpr std::int32_t kHeadings = 128;
  static constexpr int kTileBits = 4;
  static constexpr std::int32_t kTileSide = 1 << kTileBits;
  /// The codes of a cell where no robot can stand, and of no return.
  static constexpr std::uint8_t kNoFloor = 0;
  static constexpr std::uint8_t kNothing = 255;
  using Tile = std::array<std::uint8_t, std::size_t{kTileSide} * kTileSide * kHeadings>;

  /// Throws std::invalid_argument for parameters outside of their ranges.
  RangeTable(const mapping::RasterMap& map, const RangeTableParams& params);

  /// With the ring.
  const mapping::RasterMap& map() const { return map_; }
  double resolution_m() const { return map_.resolution_m(); }
  /// With the ring: all cells are within [0, columns) x [0, rows).
  const Eigen::Vector2d& origin_m() const { return map_.origin_m(); }
  std::int32_t columns() const { return map_.columns(); }
  std::int32_t rows() const { return map_.rows(); }
  bool is_floor(geometry::CellIndex cell) const {
    return map_.state(cell) == mapping::CellState::kFree;
  }

  /// Ranges up to the greatest in 126 equal parts for what is faced and what is seen at oblique
  /// incidence, in 84 where the end of the known floor is a third kind.
  std::uint8_t code_of(const models::ExpectedRange& expected) const;
  /// The middle of a code's part; nothing for kNothing. kNoFloor has none.
  models::ExpectedRange expected_of(std::uint8_t code) const;

  /// The number of the tile that a cell lies in: row by row.
  std::int32_t tile_of(geometry::CellIndex cell) const {
    return (cell.y >> kTileBits) * tile_columns_ + (cell.x >> kTileBits);
  }
  /// Fills a tile unless it is filled.
  void fill_tile(std::int32_t number);
  /// The codes of a cell, the first along the x axis and then counter-clockwise. Its tile must have
  /// been filled.
  std::span<const std::uint8_t, kHeadings> codes_at(geometry::CellIndex cell) const;
  /// By their numbers, `tile_columns()` a row; null where none is filled.
  const Tile* const* tiles() const { return tiles_.data(); }
  std::int32_t tile_columns() const { return tile_columns_; }

  std::size_t memory_bytes() const;

 private:
  bool has_floor(geometry::CellIndex first) const;
  void fill(geometry::CellIndex first, Tile& tile) const;
  void look_round(geometry::CellIndex cell, std::uint8_t* codes) const;

  RangeTableParams params_;
  mapping::RasterMap map_;
  mapping::DistanceField field_;
  std::optional<mapping::DistanceField> known_floor_;
  std::int32_t kinds_;
  std::int32_t parts_;
  std::int32_t tile_columns_;
  std::vector<Eigen::Vector2f> directions_;  ///< Of the rays that are cast.
  std::int32_t rays_aside_;                  ///< So many lie in the cone on either side.
  std::vector<const Tile*> tiles_;
  std::vector<std::unique_ptr<Tile>> filled_;
};

}  // namespace echomap::localization
