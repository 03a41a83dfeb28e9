// SPDX-License-Identifier: MIT
#include "host/mapping/distance_field.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/row_minima.hpp"
#include "host/mapping/vector_clones.hpp"

namespace echomap::mapping {

namespace {

/// The height of a column without any occupied cell; its square is the largest that row_minima
/// takes.
constexpr std::uint16_t kNoHeight = 1 << 15;

/// How far the nearest occupied cell is in each column, from the same for the row before.
ECHOMAP_VECTOR_CLONES
void step_heights(const CellState* states, std::size_t columns, std::uint16_t* heights) {
  for (std::size_t x = 0; x < columns; ++x) {
    const std::uint16_t farther = std::min<std::uint16_t>(heights[x] + 1, kNoHeight);
    heights[x] = states[x] == CellState::kOccupied ? std::uint16_t{0} : farther;
  }
}

ECHOMAP_VECTOR_CLONES
void take_lower(const std::uint16_t* other, std::size_t columns, std::uint16_t* heights) {
  for (std::size_t x = 0; x < columns; ++x) {
    heights[x] = std::min(heights[x], other[x]);
  }
}

ECHOMAP_VECTOR_CLONES
void square(const std::uint16_t* heights, std::size_t columns, std::int32_t* squares) {
  for (std::size_t x = 0; x < columns; ++x) {
    squares[x] = std::int32_t{heights[x]} * heights[x];
  }
}

/// The same, where no height above `reach` matters.
ECHOMAP_VECTOR_CLONES
void square_near(const std::uint16_t* heights,
                 std::size_t columns,
                 std::uint16_t reach,
                 std::uint16_t* squares) {
  for (std::size_t x = 0; x < columns; ++x) {
    const std::uint16_t height = std::min(heights[x], reach);
    squares[x] = static_cast<std::uint16_t>(height * height);
  }
}

template <typename Square>
[[gnu::always_inline]] inline void take_all_roots(const Square* squares,
                                                  std::size_t columns,
                                                  float most,
                                                  float* roots) {
  for (std::size_t x = 0; x < columns; ++x) {
    roots[x] = std::min(std::sqrt(static_cast<float>(squares[x])), most);
  }
}

ECHOMAP_VECTOR_CLONES
void take_roots(const std::int32_t* squares, std::size_t columns, float most, float* roots) {
  take_all_roots(squares, columns, most, roots);
}

ECHOMAP_VECTOR_CLONES
void take_roots(const std::uint16_t* squares, std::size_t columns, float most, float* roots) {
  take_all_roots(squares, columns, most, roots);
}

}  // namespace

DistanceField::DistanceField(const RasterMap& map, double max_m)
    : columns_(map.columns()),
      rows_(map.rows()),
      resolution_m_(map.resolution_m()),
      origin_m_(map.origin_m()),
      max_cells_(static_cast<float>(max_m / map.resolution_m())),
      reach_cells_(static_cast<std::int32_t>(
          std::ceil(std::min(max_m / map.resolution_m(), double{kMaxRowCells})))) {
  geometry::ParameterValidator("distance field")
      .positive("max_m", max_m)
      .at_most("columns", columns_, kMaxRowCells)
      .at_most("rows", rows_, kMaxRowCells);
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  update(map, {{0, 0}, {columns_ - 1, rows_ - 1}});
}

void DistanceField::update(const RasterMap& map, const CellBounds& changed) {
  const CellBounds within = cut(changed, 0);
  if (within.empty() || within.rows() <= 0) {
    return;
  }
  const CellBounds targets = cut(within, reach_cells_);
  const CellBounds sources = cut(targets, reach_cells_);
  find_heights(map, sources, targets);
  if (reach_cells_ <= kMaxNearReach) {
    find_near_distances(sources, targets);
  } else {
    find_distances(sources, targets);
  }
}

CellBounds DistanceField::cut(const CellBounds& bounds, std::int32_t margin) const {
  return {
      {std::max(bounds.min.x - margin, 0), std::max(bounds.min.y - margin, 0)},
      {std::min(bounds.max.x + margin, columns_ - 1), std::min(bounds.max.y + margin, rows_ - 1)}};
}

void DistanceField::find_heights(const RasterMap& map,
                                 const CellBounds& sources,
                                 const CellBounds& targets) {
  const auto columns = static_cast<std::size_t>(sources.columns());
  std::vector<std::uint16_t> heights(columns, kNoHeight);
  heights_.resize(columns * static_cast<std::size_t>(targets.rows()));
  const auto row_of = [&](std::int32_t y) {
    return heights_.data() + static_cast<std::size_t>(y - targets.min.y) * columns;
  };
  for (std::int32_t y = sources.min.y; y <= targets.max.y; ++y) {
    step_heights(map.row(y) + sources.min.x, columns, heights.data());
    if (y >= targets.min.y) {
      std::copy(heights.begin(), heights.end(), row_of(y));
    }
  }
  std::fill(heights.begin(), heights.end(), kNoHeight);
  for (std::int32_t y = sources.max.y; y >= targets.min.y; --y) {
    step_heights(map.row(y) + sources.min.x, columns, heights.data());
    if (y <= targets.max.y) {
      take_lower(heights.data(), columns, row_of(y));
    }
  }
}

void DistanceField::find_distances(const CellBounds& sources, const CellBounds& targets) {
  const auto columns = static_cast<std::size_t>(sources.columns());
  const auto target_columns = static_cast<std::size_t>(targets.columns());
  std::vector<std::int32_t> squares(columns);
  std::vector<std::int32_t> minima(target_columns);
  for (std::int32_t y = targets.min.y; y <= targets.max.y; ++y) {
    const std::uint16_t* heights =
        heights_.data() + static_cast<std::size_t>(y - targets.min.y) * columns;
    square(heights, columns, squares.data());
    row_minima(squares, targets.min.x - sources.min.x, minima);
    take_roots(minima.data(), target_columns, max_cells_, target_row(y, targets));
  }
}

void DistanceField::find_near_distances(const CellBounds& sources, const CellBounds& targets) {
  const auto columns = static_cast<std::size_t>(sources.columns());
  const auto target_columns = static_cast<std::size_t>(targets.columns());
  const auto reach = static_cast<std::uint16_t>(reach_cells_);
  const std::int32_t before = sources.min.x - targets.min.x + reach_cells_;
  std::vector<std::uint16_t> squares(target_columns + std::size_t{2} * reach + kNearPadding,
                                     static_cast<std::uint16_t>(reach * reach));
  std::vector<std::uint16_t> minima(target_columns);
  for (std::int32_t y = targets.min.y; y <= targets.max.y; ++y) {
    const std::uint16_t* heights =
        heights_.data() + static_cast<std::size_t>(y - targets.min.y) * columns;
    square_near(heights, columns, reach, squares.data() + before);
    near_row_minima(squares, reach, minima);
    take_roots(minima.data(), target_columns, max_cells_, target_row(y, targets));
  }
}

}  // namespace echomap::mapping
