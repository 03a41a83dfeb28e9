// SPDX-License-Identifier: MIT
#include "host/mapping/ray_mask.hpp"

#include <cstdlib>
#include <cstring>
#include <utility>

#include "host/mapping/vector_clones.hpp"

namespace echomap::mapping {

namespace {

/// As many neighbouring bits as always lie within 8 bytes.
constexpr std::int32_t kMostBitsAtOnce = 57;

/// Sets at most kMostBitsAtOnce bits, `first` to `last`; touches up to 7 bytes beyond the last.
inline void set_short_run(std::uint8_t* line, std::int32_t first, std::int32_t last) {
  std::uint8_t* const bytes = line + (first >> 3);
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  word |= ((std::uint64_t{2} << (last - first)) - 1) << (first & 7);
  std::memcpy(bytes, &word, sizeof word);
}

inline void set_run(std::uint8_t* line, std::int32_t first, std::int32_t last) {
  while (last - first >= kMostBitsAtOnce) {
    set_short_run(line, first, first + kMostBitsAtOnce - 1);
    first += kMostBitsAtOnce;
  }
  set_short_run(line, first, last);
}

/// A ray seen along its longer axis; lines lie across, and `line` does not fall on its way.
struct LineRay {
  std::int32_t along = 0;
  std::int32_t line = 0;
  std::int32_t to_along = 0;
  std::int32_t to_line = 0;
};

/// Marks the cells of a ray, one run a line. Where it leaves a line is kept with kPlaces places
/// behind the point and rounded up: over n lines of a ray that is d lattice units across, the error
/// stays below d / 2^40, and what lies so far beyond a border is at least 1 / d beyond, as d <
/// 2^20.
template <bool kRises>
[[gnu::always_inline]] inline void mark_lines(const LineRay& ray,
                                              std::uint8_t* line,
                                              std::ptrdiff_t line_bytes) {
  constexpr int kPlaces = 40;
  const std::int32_t lines = (ray.to_line >> kLatticeBits) - (ray.line >> kLatticeBits);
  const std::int32_t last = ray.to_along >> kLatticeBits;
  std::int32_t cell = ray.along >> kLatticeBits;
  line += (ray.line >> kLatticeBits) * line_bytes;
  if (lines > 0) {
    const std::int64_t across = ray.to_line - ray.line;
    const std::int64_t numerator =
        std::int64_t{ray.to_along - ray.along} * (std::int64_t{1} << kPlaces);
    const std::int64_t slope = numerator / across + (kRises && numerator % across != 0 ? 1 : 0);
    const std::int32_t to_border = (1 << kLatticeBits) - (ray.line & ((1 << kLatticeBits) - 1));
    auto at = static_cast<std::uint64_t>((std::int64_t{ray.along} << kPlaces) + to_border * slope);
    const std::uint64_t step = static_cast<std::uint64_t>(slope) << kLatticeBits;
    for (std::int32_t i = 0; i < lines; ++i) {
      const auto next = static_cast<std::int32_t>(at >> (kPlaces + kLatticeBits));
      set_run(line, kRises ? cell : next, kRises ? next : cell);
      cell = next;
      at += step;
      line += line_bytes;
    }
  }
  set_run(line, kRises ? cell : last, kRises ? last : cell);
}

ECHOMAP_VECTOR_CLONES
void mark(const LineRay& ray, std::uint8_t* lines, std::ptrdiff_t line_bytes) {
  if (ray.to_along >= ray.along) {
    mark_lines<true>(ray, lines, line_bytes);
  } else {
    mark_lines<false>(ray, lines, line_bytes);
  }
}

}  // namespace

void RayMask::reset(std::int32_t tile_columns, std::int32_t tile_rows) {
  tile_columns_ = tile_columns;
  tile_rows_ = tile_rows;
  const auto words =
      static_cast<std::size_t>(tile_columns) * static_cast<std::size_t>(tile_rows) * kTileSide + 1;
  flat_.assign(words, 0);
  steep_.assign(words, 0);
}

void RayMask::add_ray(LatticePoint from, LatticePoint to) {
  if (std::abs(to.x - from.x) >= std::abs(to.y - from.y)) {
    if (to.y < from.y) {
      std::swap(from, to);
    }
    mark({from.x, from.y, to.x, to.y},
         reinterpret_cast<std::uint8_t*>(flat_.data()),
         tile_columns_ * 8);
    return;
  }
  if (to.x < from.x) {
    std::swap(from, to);
  }
  mark(
      {from.y, from.x, to.y, to.x}, reinterpret_cast<std::uint8_t*>(steep_.data()), tile_rows_ * 8);
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
