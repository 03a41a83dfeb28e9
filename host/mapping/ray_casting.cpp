// SPDX-License-Identifier: MIT
#include "host/mapping/ray_casting.hpp"

#include <algorithm>
#include <array>

#include "host/mapping/vector_clones.hpp"

namespace echomap::mapping {

namespace {

constexpr std::size_t kLanes = 8;
using Floats = float __attribute__((vector_size(4 * kLanes)));
using Whole = std::int32_t __attribute__((vector_size(4 * kLanes)));

/// The field as the kernel sees it, and where all rays begin, in cells.
struct FieldView {
  const float* distances;
  std::int32_t columns;
  std::int32_t rows;
  float from_x;
  float from_y;
  float most;
};

/// Looks so far beyond a border, in cells, to see which cell lies there: more than what a float of
/// some thousand cells is rounded to.
constexpr float kPeek = 1e-3F;
/// From a point of one cell to the nearest of another it may be nearer than from centre to centre,
/// by half a diagonal of either.
constexpr float kTwoHalfDiagonals = 1.4143F;

/// An occupied cell that is at most k columns and k rows off is at most k diagonals far, so a
/// distance of d cells says that the square of floor(d / sqrt(2)) cells to all sides is clear. A
/// hair less, for roundings.
constexpr float kClearSquare = 0.7071F;
/// The latency of one step leaves time for as many.
constexpr std::size_t kGroups = 4;

/// Eight rays in flight, in cells.
struct Rays {
  std::size_t first = 0;  ///< The number of the first of them.
  std::int32_t steps_left = 0;
  Floats way_x;
  Floats way_y;
  Floats per_direction_x;  ///< 1 / way.
  Floats per_direction_y;
  Floats sign_x;  ///< 1 or -1.
  Floats sign_y;
  Floats range;
  Whole going;
};

/// Where rays are: the middles of their cells and what the field says there.
struct Cells {
  Floats middle_x;
  Floats middle_y;
  Floats clear;
  Whole is_outside;
};

[[gnu::always_inline]] inline void truncate(Floats& values) {
  values = __builtin_convertvector(__builtin_convertvector(values, Whole), Floats);
}

/// The nearest columns or rows that the map has.
[[gnu::always_inline]] inline void put_in_map(std::int32_t count, Floats& at) {
  const Floats last = Floats{} + (static_cast<float>(count) - 0.5F);
  at = at > 0.0F ? at : Floats{};
  at = at < last ? at : last;
  truncate(at);
}

[[gnu::always_inline]] inline void look(const FieldView& view, const Rays& rays, Cells& cells) {
  const Floats x = view.from_x + (rays.range + kPeek) * rays.way_x;
  const Floats y = view.from_y + (rays.range + kPeek) * rays.way_y;
  Floats low_x = x;
  Floats low_y = y;
  put_in_map(view.columns, low_x);
  put_in_map(view.rows, low_y);
  cells.middle_x = low_x + 0.5F;
  cells.middle_y = low_y + 0.5F;
  cells.is_outside = (x < low_x) | (x >= low_x + 1.0F) | (y < low_y) | (y >= low_y + 1.0F);
  const Whole index =
      __builtin_convertvector(low_y, Whole) * view.columns + __builtin_convertvector(low_x, Whole);
  Floats clear;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    clear[lane] = view.distances[index[lane]];
  }
  cells.clear = clear;
}

/// Takes 8 rays a step farther, to the border of the clear square around their cell or through the
/// clear disc, whichever is farther; says whether any goes on.
[[gnu::always_inline]] inline bool step(const FieldView& view, Rays& rays) {
  Cells cells;
  look(view, rays, cells);
  Floats half_side = cells.clear * kClearSquare;
  truncate(half_side);
  half_side += 0.5F;
  const Floats to_x =
      (cells.middle_x - view.from_x + rays.sign_x * half_side) * rays.per_direction_x;
  const Floats to_y =
      (cells.middle_y - view.from_y + rays.sign_y * half_side) * rays.per_direction_y;
  const Floats to_border = to_x < to_y ? to_x : to_y;
  Floats next = rays.range + cells.clear - kTwoHalfDiagonals;
  next = next > to_border ? next : to_border;
  next = cells.is_outside ? Floats{} + view.most : next;
  next = next < view.most ? next : Floats{} + view.most;
  const Whole moves = rays.going & (cells.is_outside | (cells.clear > 0.0F));
  rays.range = moves ? next : rays.range;
  rays.going = moves & (next < view.most);
  std::int32_t is_any_left = 0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    is_any_left |= rays.going[lane];
  }
  return is_any_left != 0 && --rays.steps_left > 0;
}

/// Rays from number `first` at their beginning; the last direction again where less than 8 are
/// left.
[[gnu::always_inline]] inline void begin(const FieldView& view,
                                         std::span<const Eigen::Vector2f> directions,
                                         std::size_t first,
                                         Rays& rays) {
  constexpr float kLeast = 1e-9F;  // One may divide by it.
  rays.first = first;
  rays.steps_left = 2 * (view.columns + view.rows) + 2;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const Eigen::Vector2f& direction = directions[std::min(first + i, directions.size() - 1)];
    rays.way_x[i] = std::abs(direction.x()) < kLeast ? kLeast : direction.x();
    rays.way_y[i] = std::abs(direction.y()) < kLeast ? kLeast : direction.y();
  }
  rays.per_direction_x = 1.0F / rays.way_x;
  rays.per_direction_y = 1.0F / rays.way_y;
  rays.sign_x = rays.way_x > 0.0F ? Floats{} + 1.0F : Floats{} - 1.0F;
  rays.sign_y = rays.way_y > 0.0F ? Floats{} + 1.0F : Floats{} - 1.0F;
  rays.range = Floats{};
  rays.going = Whole{} - 1;
}

/// Follows rays to their ends, some groups of 8 by turns: one that ends makes place for the next.
ECHOMAP_VECTOR_CLONES
void follow(const FieldView& view,
            std::span<const Eigen::Vector2f> directions,
            std::span<float> ranges) {
  std::array<Rays, kGroups> groups;
  std::size_t begun = 0;
  std::size_t flying = 0;
  for (; flying < kGroups && begun < directions.size(); ++flying, begun += kLanes) {
    begin(view, directions, begun, groups[flying]);
  }
  while (flying != 0) {
    for (std::size_t group = 0; group < flying; ++group) {
      Rays& rays = groups[group];
      if (step(view, rays)) {
        continue;
      }
      for (std::size_t i = 0; i < std::min(kLanes, directions.size() - rays.first); ++i) {
        ranges[rays.first + i] = rays.range[i];
      }
      if (begun < directions.size()) {
        begin(view, directions, begun, rays);
        begun += kLanes;
      } else {
        rays = groups[--flying];
      }
    }
  }
}

}  // namespace

void cast_rays(const DistanceField& field,
               const Eigen::Vector2d& from_m,
               std::span<const Eigen::Vector2f> directions,
               double max_m,
               std::span<float> ranges_m) {
  const Eigen::Vector2f from = ((from_m - field.origin_m()) / field.resolution_m()).cast<float>();
  const auto resolution_m = static_cast<float>(field.resolution_m());
  const FieldView view{field.row(0),
                       field.columns(),
                       field.rows(),
                       from.x(),
                       from.y(),
                       static_cast<float>(max_m) / resolution_m};
  follow(view, directions, ranges_m);
  for (float& range_m : ranges_m.first(directions.size())) {
    range_m *= resolution_m;
  }
}

}  // namespace echomap::mapping
