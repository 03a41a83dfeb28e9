// SPDX-License-Identifier: MIT
#include "host/mapping/ray_casting.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/geometry/unit_vector.hpp"
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

/// Eight rays in flight, in cells.
struct Rays {
  Floats way_x;
  Floats way_y;
  Floats per_way_x;  ///< 1 / way.
  Floats per_way_y;
  Floats side_x;  ///< Which border of a cell lies ahead: 1 for the upper, 0 for the lower.
  Floats side_y;
  Floats range;
};

[[gnu::always_inline]] inline void cut(Floats& values, float low, float high) {
  values = values > low ? values : Floats{} + low;
  values = values < high ? values : Floats{} + high;
}

/// Follows 8 rays to their ends.
ECHOMAP_VECTOR_CLONES
void follow(const FieldView& view, Rays& rays) {
  const std::int32_t most_steps = 2 * (view.columns + view.rows) + 2;
  Whole going = Whole{} - 1;
  std::int32_t is_any_left = 1;
  for (std::int32_t i = 0; i < most_steps && is_any_left != 0; ++i) {
    const Floats x = view.from_x + (rays.range + kPeek) * rays.way_x;
    const Floats y = view.from_y + (rays.range + kPeek) * rays.way_y;
    Floats low_x = x;
    Floats low_y = y;
    cut(low_x, 0.0F, static_cast<float>(view.columns) - 0.5F);
    cut(low_y, 0.0F, static_cast<float>(view.rows) - 0.5F);
    const Whole column = __builtin_convertvector(low_x, Whole);
    const Whole row = __builtin_convertvector(low_y, Whole);
    low_x = __builtin_convertvector(column, Floats);
    low_y = __builtin_convertvector(row, Floats);
    const Whole is_outside = (x < low_x) | (x >= low_x + 1.0F) | (y < low_y) | (y >= low_y + 1.0F);
    const Whole index = row * view.columns + column;
    Floats clear;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      clear[lane] = view.distances[index[lane]];
    }
    const Floats to_x = (low_x + rays.side_x - view.from_x) * rays.per_way_x;
    const Floats to_y = (low_y + rays.side_y - view.from_y) * rays.per_way_y;
    const Floats to_border = to_x < to_y ? to_x : to_y;
    Floats next = rays.range + clear - kTwoHalfDiagonals;
    next = next > to_border ? next : to_border;
    next = is_outside ? Floats{} + view.most : next;
    next = next < view.most ? next : Floats{} + view.most;
    going &= is_outside | (clear > 0.0F);
    rays.range = going ? next : rays.range;
    going &= next < view.most;
    is_any_left = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      is_any_left |= going[lane];
    }
  }
}

/// Rays at their beginning; the last direction again where there are less than 8.
Rays rays_along(std::span<const Eigen::Vector2f> directions) {
  constexpr float kLeast = 1e-9F;  // One may divide by it.
  Rays rays{};
  for (std::size_t i = 0; i < kLanes; ++i) {
    const Eigen::Vector2f& way = directions[std::min(i, directions.size() - 1)];
    rays.way_x[i] = std::abs(way.x()) < kLeast ? kLeast : way.x();
    rays.way_y[i] = std::abs(way.y()) < kLeast ? kLeast : way.y();
  }
  rays.per_way_x = 1.0F / rays.way_x;
  rays.per_way_y = 1.0F / rays.way_y;
  rays.side_x = rays.way_x > 0.0F ? Floats{} + 1.0F : Floats{};
  rays.side_y = rays.way_y > 0.0F ? Floats{} + 1.0F : Floats{};
  return rays;
}

}  // namespace

void cast_rays(const DistanceField& field,
               const Eigen::Vector2d& from_m,
               std::span<const Eigen::Vector2f> directions,
               double most_m,
               std::span<float> ranges_m) {
  const Eigen::Vector2f from = ((from_m - field.origin_m()) / field.resolution_m()).cast<float>();
  const auto resolution_m = static_cast<float>(field.resolution_m());
  const FieldView view{field.row(0),
                       field.columns(),
                       field.rows(),
                       from.x(),
                       from.y(),
                       static_cast<float>(most_m) / resolution_m};
  for (std::size_t begin = 0; begin < directions.size(); begin += kLanes) {
    const std::size_t lanes = std::min(kLanes, directions.size() - begin);
    Rays rays = rays_along(directions.subspan(begin, lanes));
    follow(view, rays);
    for (std::size_t i = 0; i < lanes; ++i) {
      ranges_m[begin + i] = rays.range[i] * resolution_m;
    }
  }
}

double cone_range_m(const DistanceField& field,
                    const Eigen::Vector2d& from_m,
                    double bearing_rad,
                    double half_opening_rad,
                    double most_m) {
  const double arc_cells = 2.0 * half_opening_rad * most_m / field.resolution_m();
  const int gaps = std::max(1, static_cast<int>(std::ceil(arc_cells)));
  double nearest_m = most_m;
  std::array<Eigen::Vector2f, kLanes> directions;
  std::array<float, kLanes> ranges_m{};
  for (int begin = 0; begin <= gaps; begin += static_cast<int>(kLanes)) {
    for (int i = 0; i < static_cast<int>(kLanes); ++i) {
      const double share = std::min(1.0, static_cast<double>(begin + i) / gaps);
      const double off_axis_rad = half_opening_rad * (2.0 * share - 1.0);
      directions[static_cast<std::size_t>(i)] =
          geometry::unit_vector(bearing_rad + off_axis_rad).cast<float>();
    }
    cast_rays(field, from_m, directions, most_m, ranges_m);
    nearest_m = std::min<double>(nearest_m, *std::min_element(ranges_m.begin(), ranges_m.end()));
  }
  return nearest_m;
}

}  // namespace echomap::mapping
