// SPDX-License-Identifier: MIT
#include "host/mapping/sector_rows.hpp"

#include <algorithm>
#include <cmath>

#include "host/mapping/vector_clones.hpp"

namespace echomap::mapping {

namespace {

/// So many rows are worked out at once.
constexpr std::int32_t kBlock = 16;
/// More than what rows_of spares below and above.
constexpr std::int32_t kSpareRows = 16;

constexpr std::int16_t kLeast = INT16_MIN;
constexpr std::int16_t kMost = INT16_MAX;

struct Rows {
  std::int32_t first = 0;
  std::int32_t blocks = 0;
};

/// The rows that a wedge can share with a ring, with some to spare.
Rows rows_of(const Wedge& wedge, const Ring& ring) {
  const Eigen::Vector2d& left = wedge.left_ray;
  const Eigen::Vector2d& right = wedge.right_ray;
  const double near = std::sqrt(std::max(ring.hole, 0));
  const double far = std::sqrt(ring.rim);
  const double most = left.x() <= 0.0 && right.x() >= 0.0 ? 1.0 : std::max(left.y(), right.y());
  const double least = left.x() >= 0.0 && right.x() <= 0.0 ? -1.0 : std::min(left.y(), right.y());
  const double spare = 2.0 + far / (1 << kSlopeBits);
  const auto first = static_cast<std::int32_t>(least * (least < 0.0 ? far : near) - spare);
  const auto last = static_cast<std::int32_t>(most * (most > 0.0 ? far : near) + spare);
  return {first, (last - first + kBlock) / kBlock};
}

// Loops without branches, which would keep them out of vectors.

[[gnu::always_inline]] inline std::int16_t least(std::int16_t one, std::int16_t other) {
  return one < other ? one : other;
}

[[gnu::always_inline]] inline std::int16_t most(std::int16_t one, std::int16_t other) {
  return one > other ? one : other;
}

[[gnu::always_inline]] inline std::int16_t mask(bool is_set) {
  return static_cast<std::int16_t>(-static_cast<int>(is_set));
}

[[gnu::always_inline]] inline std::int16_t either(std::int16_t chosen,
                                                  std::int16_t one,
                                                  std::int16_t other) {
  return static_cast<std::int16_t>((one & chosen) | (other & ~chosen));
}

/// The columns whose cells' distance squared is at most `square`, which is below 2^22.
[[gnu::always_inline]] inline void lay_out_disc(std::int32_t square,
                                                const Rows& rows,
                                                std::int16_t* __restrict minus_from,
                                                std::int16_t* __restrict minus_to) {
  for (std::int32_t i = 0; i < rows.blocks * kBlock; ++i) {
    const std::int32_t y = rows.first + i;
    const std::int32_t left = square - y * y;
    const auto root = static_cast<std::int32_t>(std::sqrt(static_cast<float>(std::max(left, 0))));
    minus_from[i] = static_cast<std::int16_t>(root);
    minus_to[i] = static_cast<std::int16_t>(left < 0 ? 0 : -1 - root);
  }
}

/// What a side leaves of a row's columns.
[[gnu::always_inline]] inline void keep(const Side& side,
                                        std::int32_t y,
                                        std::int32_t& from,
                                        std::int32_t& to) {
  constexpr std::int32_t kUp = (1 << kSlopeBits) - 1;
  const std::int32_t border = side.slope * y;
  from = side.is_from_border ? std::max(from, (border + kUp) >> kSlopeBits) : from;
  to = side.is_from_border ? to : std::min(to, (border >> kSlopeBits) + 1);
}

/// What a wedge leaves of a disc.
[[gnu::always_inline]] inline void cut(const Wedge& wedge,
                                       const Rows& rows,
                                       const std::int16_t* __restrict minus_disc_from,
                                       const std::int16_t* __restrict minus_disc_to,
                                       std::int16_t* __restrict minus_from,
                                       std::int16_t* __restrict minus_to) {
  const Side one = wedge.right_of_left;
  const Side other = wedge.left_of_right;
  for (std::int32_t i = 0; i < rows.blocks * kBlock; ++i) {
    const std::int32_t disc_to = -minus_disc_to[i];
    std::int32_t from = -minus_disc_from[i];
    std::int32_t to = disc_to;
    keep(one, rows.first + i, from, to);
    keep(other, rows.first + i, from, to);
    from = std::min(from, disc_to);
    minus_from[i] = static_cast<std::int16_t>(-from);
    minus_to[i] = static_cast<std::int16_t>(-std::max(from, to));
  }
}

/// From the first to the last cell of each row that is in a wedge and not in a hole.
[[gnu::always_inline]] inline void cut_out(const Rows& rows,
                                           const std::int16_t* __restrict wedge_from,
                                           const std::int16_t* __restrict wedge_to,
                                           const std::int16_t* __restrict hole_from,
                                           const std::int16_t* __restrict hole_to,
                                           std::int16_t* __restrict minus_from,
                                           std::int16_t* __restrict minus_to) {
  for (std::int32_t i = 0; i < rows.blocks * kBlock; ++i) {
    const std::int16_t from = wedge_from[i];
    const std::int16_t to = wedge_to[i];
    const std::int16_t hole_first = hole_from[i];
    const std::int16_t hole_end = hole_to[i];
    minus_from[i] = hole_first >= from ? least(from, hole_end) : from;
    minus_to[i] = hole_end <= to ? most(to, hole_first) : to;
  }
}

/// The rectangle around the cells of all rows.
[[gnu::always_inline]] inline CellBounds bound(const Rows& rows,
                                               const std::int16_t* __restrict minus_from,
                                               const std::int16_t* __restrict minus_to) {
  std::int16_t most_from = kLeast;
  std::int16_t least_to = kMost;
  std::int16_t first = kMost;
  std::int16_t last = kLeast;
  for (std::int32_t i = 0; i < rows.blocks * kBlock; ++i) {
    const std::int16_t from = minus_from[i];
    const std::int16_t to = minus_to[i];
    const auto y = static_cast<std::int16_t>(rows.first + i);
    const std::int16_t has_cells = mask(from > to);
    most_from = most(most_from, either(has_cells, from, kLeast));
    least_to = least(least_to, either(has_cells, to, kMost));
    first = least(first, either(has_cells, y, kMost));
    last = most(last, either(has_cells, y, kLeast));
  }
  if (last < first) {
    return {};
  }
  return {{-most_from, first}, {-least_to - 1, last}};
}

/// Writes the columns of each wedge and, with a hole, of the hole and of the cells; each as those
/// from where it begins and, `stride` on, those to where it ends. The rectangle around all cells.
ECHOMAP_VECTOR_CLONES
CellBounds lay_out_rows(std::span<const Wedge> wedges,
                        const Ring& ring,
                        const Rows& rows,
                        std::size_t stride,
                        std::int16_t* columns) {
  std::int16_t* const hole = columns + 2 * wedges.size() * stride;
  std::int16_t* const cells = hole + 2 * stride;
  lay_out_disc(ring.rim, rows, cells, cells + stride);
  std::int16_t* at = columns;
  for (const Wedge& wedge : wedges) {
    cut(wedge, rows, cells, cells + stride, at, at + stride);
    at += 2 * stride;
  }
  if (ring.hole < 0) {
    return bound(rows, columns, columns + stride);
  }
  lay_out_disc(ring.hole, rows, hole, hole + stride);
  cut_out(rows, columns, columns + stride, hole, hole + stride, cells, cells + stride);
  return bound(rows, cells, cells + stride);
}

/// The first and the last of the rows with cells in columns that are given negated.
ECHOMAP_VECTOR_CLONES
Stretch rows_between(std::int16_t minus_first,
                     std::int16_t minus_end,
                     const Rows& rows,
                     const std::int16_t* __restrict minus_from,
                     const std::int16_t* __restrict minus_to) {
  std::int16_t first = kMost;
  std::int16_t last = kLeast;
  for (std::int32_t i = 0; i < rows.blocks * kBlock; ++i) {
    const std::int16_t from = least(minus_from[i], minus_first);
    const std::int16_t to = most(minus_to[i], minus_end);
    const auto y = static_cast<std::int16_t>(rows.first + i);
    const std::int16_t has_cells = mask(from > to);
    first = least(first, either(has_cells, y, kMost));
    last = most(last, either(has_cells, y, kLeast));
  }
  return {first, last};
}

Eigen::Vector2d aside(const Eigen::Vector2d& axis) { return {-axis.y(), axis.x()}; }

}  // namespace

Side::Side(const Eigen::Vector2d& ray, bool is_right)
    : is_from_border((ray.y() >= 0.0) == is_right) {
  constexpr double kFlattest = kMostSectorCells + 1;
  const double columns = std::clamp(ray.x() / ray.y(), -kFlattest, kFlattest) * (1 << kSlopeBits);
  slope = static_cast<std::int32_t>(columns + std::copysign(0.5, columns));
}

Wedge::Wedge(const Eigen::Vector2d& axis, const Eigen::Vector2d& half_opening)
    : left_ray(half_opening.x() * axis + half_opening.y() * aside(axis)),
      right_ray(half_opening.x() * axis - half_opening.y() * aside(axis)),
      right_of_left(left_ray, true),
      left_of_right(right_ray, false) {}

SectorRows::SectorRows(std::size_t wedges, std::int32_t reach_cells)
    : wedges_(wedges),
      stride_(static_cast<std::size_t>(2 * reach_cells + 1 + kSpareRows + kBlock)),
      columns_(2 * (wedges + 2) * stride_) {}

void SectorRows::lay_out(std::span<const Wedge> wedges, const Ring& ring) {
  const Rows rows = rows_of(wedges.front(), ring);
  first_row_ = rows.first;
  row_blocks_ = rows.blocks;
  has_hole_ = ring.hole >= 0;
  bounds_ = lay_out_rows(wedges, ring, rows, stride_, columns_.data());
}

Stretch SectorRows::rows_in(const Stretch& columns) const {
  const RowColumns all = cells();
  return rows_between(static_cast<std::int16_t>(-columns.first),
                      static_cast<std::int16_t>(-columns.last - 1),
                      {first_row_, row_blocks_},
                      all.minus_from,
                      all.minus_to);
}

}  // namespace echomap::mapping
