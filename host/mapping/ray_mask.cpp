// SPDX-License-Identifier: MIT
#include "host/mapping/ray_mask.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "host/mapping/vector_clones.hpp"

namespace echomap::mapping {

namespace {

/// As many neighbouring bits as always lie within 8 bytes.
constexpr std::int32_t kMaxBitsAtOnce = 57;

/// Sets at most kMaxBitsAtOnce bits, `first` to `last`; touches up to 7 bytes beyond the last.
inline void set_short_run(std::uint8_t* line, std::int32_t first, std::int32_t last) {
  std::uint8_t* const bytes = line + (first >> 3);
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  word |= ((std::uint64_t{2} << (last - first)) - 1) << (first & 7);
  std::memcpy(bytes, &word, sizeof word);
}

inline void set_run(std::uint8_t* line, std::int32_t first, std::int32_t last) {
  while (last - first >= kMaxBitsAtOnce) {
    set_short_run(line, first, first + kMaxBitsAtOnce - 1);
    first += kMaxBitsAtOnce;
  }
  set_short_run(line, first, last);
}

/// A ray seen along its longer axis; lines lie across, and `line` does not fall on its way. Those
/// from number `first_line`, that of `line` being 0, to before `end_line` are wanted.
struct LineRay {
  std::int32_t along = 0;
  std::int32_t line = 0;
  std::int32_t to_along = 0;
  std::int32_t to_line = 0;
  std::int32_t first_line = 0;
  std::int32_t end_line = 0;

  std::int32_t last_line() const { return (to_line >> kLatticeBits) - (line >> kLatticeBits); }
};

constexpr std::int32_t kLanes = 8;
using Lanes = std::int64_t __attribute__((vector_size(8 * kLanes)));
constexpr Lanes kLaneNumbers = {0, 1, 2, 3, 4, 5, 6, 7};

/// Where a ray leaves its lines, with kPlaces places behind the point and rounded up: over n lines
/// of a ray that is d lattice units across, the error stays below d / 2^40, and what lies so far
/// beyond a border is at least 1 / d beyond, as d < 2^20.
struct Exits {
  static constexpr int kPlaces = 40;
  static constexpr int kCellPlaces = kPlaces + kLatticeBits;

  explicit Exits(const LineRay& ray) {
    const std::int64_t across = ray.to_line - ray.line;
    const std::int64_t along = ray.to_along - ray.along;
    const std::int64_t numerator = along * (std::int64_t{1} << kPlaces);
    slope = numerator / across + (along > 0 && numerator % across != 0 ? 1 : 0);
    const std::int32_t to_border = (1 << kLatticeBits) - (ray.line & ((1 << kLatticeBits) - 1));
    first = (std::int64_t{ray.along} << kPlaces) + to_border * slope;
  }

  std::int64_t first = 0;
  std::int64_t slope = 0;  ///< From one line to the next the exit moves on by as many cells.
};

/// Marks the cells of a ray whose runs fit kMaxBitsAtOnce, 8 lines at once; touches up to 7 lines
/// beyond the last, but changes none there.
template <bool kRises>
[[gnu::always_inline]] inline void mark_lines(const LineRay& ray,
                                              const Exits& exits,
                                              std::uint8_t* line,
                                              std::ptrdiff_t line_bytes) {
  const Lanes begin = Lanes{} + (ray.along >> kLatticeBits);
  const Lanes end = Lanes{} + (ray.to_along >> kLatticeBits);
  const std::int64_t step = exits.slope * (1 << kLatticeBits);
  const Lanes to_line = kLaneNumbers * line_bytes;
  line += ray.first_line * line_bytes;
  for (std::int32_t i = ray.first_line; i < ray.end_line; i += kLanes) {
    const Lanes number = i + kLaneNumbers;
    const Lanes exit = exits.first + number * step;
    Lanes enters = (exit - step) >> Exits::kCellPlaces;
    Lanes leaves = exit >> Exits::kCellPlaces;
    if (kRises) {
      enters = enters > begin ? enters : begin;
      enters = enters < end ? enters : end;
      leaves = leaves < end ? leaves : end;
    } else {
      enters = enters < begin ? enters : begin;
      leaves = leaves > end ? leaves : end;
      enters = enters > leaves ? enters : leaves;
    }
    const Lanes low = kRises ? enters : leaves;
    const Lanes high = kRises ? leaves : enters;
    Lanes run = ((Lanes{} + 2) << (high - low)) - 1;
    run = number < ray.end_line ? run << (low & 7) : Lanes{};
    const Lanes byte = to_line + (low >> 3);
    for (std::int32_t lane = 0; lane < kLanes; ++lane) {
      std::uint64_t word = 0;
      std::memcpy(&word, line + byte[lane], sizeof word);
      word |= static_cast<std::uint64_t>(run[lane]);
      std::memcpy(line + byte[lane], &word, sizeof word);
    }
    line += kLanes * line_bytes;
  }
}

/// The same for a ray of any slope, line by line. What its last exit overflows to is not used.
inline void mark_long_runs(const LineRay& ray,
                           const Exits& exits,
                           std::uint8_t* line,
                           std::ptrdiff_t line_bytes) {
  std::int32_t cell = ray.along >> kLatticeBits;
  auto exit = static_cast<std::uint64_t>(exits.first);
  for (std::int32_t i = 0; i <= ray.last_line(); ++i) {
    const auto next = i == ray.last_line() ? ray.to_along >> kLatticeBits
                                           : static_cast<std::int32_t>(exit >> Exits::kCellPlaces);
    set_run(line, std::min(cell, next), std::max(cell, next));
    cell = next;
    exit += static_cast<std::uint64_t>(exits.slope) << kLatticeBits;
    line += line_bytes;
  }
}

template <bool kRises>
[[gnu::always_inline]] inline void mark_ray(const LineRay& ray,
                                            std::uint8_t* lines,
                                            std::ptrdiff_t line_bytes) {
  constexpr std::int64_t kSteepest = std::int64_t{kMaxBitsAtOnce - 2} << Exits::kPlaces;
  lines += (ray.line >> kLatticeBits) * line_bytes;
  if (ray.last_line() == 0) {
    const std::int32_t begin = ray.along >> kLatticeBits;
    const std::int32_t end = ray.to_along >> kLatticeBits;
    set_run(lines, kRises ? begin : end, kRises ? end : begin);
    return;
  }
  const Exits exits(ray);
  if (exits.slope > kSteepest || exits.slope < -kSteepest) {
    mark_long_runs(ray, exits, lines, line_bytes);
    return;
  }
  mark_lines<kRises>(ray, exits, lines, line_bytes);
}

/// Turns a ray so that lines rise, and leaves out those that it only meets in the first share of
/// its way. It leaves line k, the first being 0, at the share (k + b) / n, where n lines fit into
/// its way and b < 1 to the first border.
inline LineRay rising(LineRay ray, double covered_share) {
  constexpr double kPerCell = 1.0 / (1 << kLatticeBits);
  const double lines = std::abs(ray.to_line - ray.line) * kPerCell;
  const auto covered = static_cast<std::int32_t>(std::clamp(covered_share, 0.0, 1.0) * lines);
  if (ray.to_line < ray.line) {
    std::swap(ray.along, ray.to_along);
    std::swap(ray.line, ray.to_line);
    ray.end_line = ray.last_line() + 1 - covered;
  } else {
    ray.first_line = covered;
    ray.end_line = ray.last_line() + 1;
  }
  return ray;
}

[[gnu::always_inline]] inline void mark_rising(const LineRay& ray,
                                               std::uint8_t* lines,
                                               std::ptrdiff_t line_bytes) {
  if (ray.to_along >= ray.along) {
    mark_ray<true>(ray, lines, line_bytes);
  } else {
    mark_ray<false>(ray, lines, line_bytes);
  }
}

/// A mask's first line and the bytes of a line.
struct Lines {
  std::uint8_t* first;
  std::ptrdiff_t bytes;
};

ECHOMAP_VECTOR_CLONES
void mark(LatticePoint from,
          std::span<const LatticePoint> directions,
          const double* covered_shares,
          Lines flat,
          Lines steep) {
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const LatticePoint to{from.x + directions[i].x, from.y + directions[i].y};
    if (std::abs(directions[i].x) >= std::abs(directions[i].y)) {
      mark_rising(rising({from.x, from.y, to.x, to.y}, covered_shares[i]), flat.first, flat.bytes);
    } else {
      mark_rising(
          rising({from.y, from.x, to.y, to.x}, covered_shares[i]), steep.first, steep.bytes);
    }
  }
}

}  // namespace

void RayMask::reset(std::int32_t tile_columns, std::int32_t tile_rows) {
  tile_columns_ = tile_columns;
  tile_rows_ = tile_rows;
  const auto columns = static_cast<std::size_t>(tile_columns);
  const auto rows = static_cast<std::size_t>(tile_rows);
  flat_.assign((rows * kTileSide + kLanes) * columns + 1, 0);
  steep_.assign((columns * kTileSide + kLanes) * rows + 1, 0);
}

void RayMask::add_rays(LatticePoint from,
                       std::span<const LatticePoint> directions,
                       std::span<const double> covered_shares) {
  mark(from,
       directions,
       covered_shares.data(),
       {reinterpret_cast<std::uint8_t*>(flat_.data()), std::ptrdiff_t{tile_columns_} * 8},
       {reinterpret_cast<std::uint8_t*>(steep_.data()), std::ptrdiff_t{tile_rows_} * 8});
}

void RayMask::add_quadrant(LatticePoint center, Quadrant quadrant, double radius) {
  constexpr std::int32_t kCell = 1 << kLatticeBits;
  const bool is_left = quadrant == Quadrant::kLeftUp || quadrant == Quadrant::kLeftDown;
  const bool is_down = quadrant == Quadrant::kLeftDown || quadrant == Quadrant::kRightDown;
  const auto reach = static_cast<std::int32_t>(radius);
  // The first column and row whose middles are not left of, or below, the centre.
  const std::int32_t first_column = (center.x + kCell / 2 - 1) >> kLatticeBits;
  const std::int32_t first_row = (center.y + kCell / 2 - 1) >> kLatticeBits;
  const std::int32_t lowest =
      is_down ? (center.y - reach + kCell / 2 - 1) >> kLatticeBits : first_row;
  const std::int32_t highest =
      is_down ? first_row - 1 : (center.y + reach - kCell / 2) >> kLatticeBits;
  for (std::int32_t row = lowest; row <= highest; ++row) {
    const std::int32_t middle = row * kCell + kCell / 2;
    const double up = middle - center.y;
    const auto width =
        static_cast<std::int32_t>(std::sqrt(std::max(radius * radius - up * up, 0.0)));
    const std::int32_t from =
        is_left ? (center.x - width + kCell / 2 - 1) >> kLatticeBits : first_column;
    const std::int32_t to =
        is_left ? first_column - 1 : (center.x + width - kCell / 2) >> kLatticeBits;
    if (from <= to) {
      set_run(
          reinterpret_cast<std::uint8_t*>(flat_.data()) + std::ptrdiff_t{row} * tile_columns_ * 8,
          from,
          to);
    }
  }
}

TileBits RayMask::tile(std::int32_t column, std::int32_t row) const {
  TileBits bits{};
  const auto columns = static_cast<std::size_t>(tile_columns_);
  const auto rows = static_cast<std::size_t>(tile_rows_);
  const std::size_t first_steep =
      static_cast<std::size_t>(column) * kTileSide * rows + static_cast<std::size_t>(row);
  const std::size_t first_flat =
      static_cast<std::size_t>(row) * kTileSide * columns + static_cast<std::size_t>(column);
  std::uint64_t any = 0;
  for (std::size_t i = 0; i < kTileSide; ++i) {
    bits[i] = steep_[first_steep + i * rows];
    any |= bits[i];
  }
  if (any != 0) {
    transpose(bits);
  }
  for (std::size_t i = 0; i < kTileSide; ++i) {
    bits[i] |= flat_[first_flat + i * columns];
  }
  return bits;
}

}  // namespace echomap::mapping
