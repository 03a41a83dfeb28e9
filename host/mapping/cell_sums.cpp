// SPDX-License-Identifier: MIT
#include "host/mapping/cell_sums.hpp"

#include <algorithm>
#include <utility>

#include "host/geometry/whole_cell.hpp"

namespace echomap::mapping {
namespace {

/// A side of the bounds that has to move moves so many cells farther.
constexpr std::int32_t kGrowth = 64;
/// More cells are not held: 200 by 200 m at 5 cm take 64 MB.
constexpr std::int64_t kMaxHeldCells = std::int64_t{1} << 24;

CellBounds grown(const CellBounds& held, const CellBounds& wanted) {
  if (held.empty()) {
    return {{wanted.min.x - kGrowth, wanted.min.y - kGrowth},
            {wanted.max.x + kGrowth, wanted.max.y + kGrowth}};
  }
  const auto lower = [](std::int32_t is, std::int32_t to) { return to < is ? to - kGrowth : is; };
  const auto upper = [](std::int32_t is, std::int32_t to) { return to > is ? to + kGrowth : is; };
  return {{lower(held.min.x, wanted.min.x), lower(held.min.y, wanted.min.y)},
          {upper(held.max.x, wanted.max.x), upper(held.max.y, wanted.max.y)}};
}

}  // namespace

CellBounds cells_around(const Eigen::Array2d& low_m,
                        const Eigen::Array2d& high_m,
                        double resolution_m) {
  const auto cell = [&](double at_m) { return geometry::whole_cell(at_m / resolution_m); };
  return {{cell(low_m.x()), cell(low_m.y())}, {cell(high_m.x()), cell(high_m.y())}};
}

bool CellSums::can_hold(const CellBounds& bounds) const {
  const CellBounds all = united(bounds_, bounds);
  if (all == bounds_) {
    return true;
  }
  const std::int64_t columns = std::int64_t{all.max.x} - all.min.x + 1 + 2 * kGrowth;
  const std::int64_t rows = std::int64_t{all.max.y} - all.min.y + 1 + 2 * kGrowth;
  return columns <= kMaxHeldCells && rows <= kMaxHeldCells && columns * rows <= kMaxHeldCells;
}

void CellSums::hold(const CellBounds& bounds) {
  const CellBounds wanted = united(bounds_, bounds);
  if (wanted == bounds_) {
    return;
  }
  const CellBounds before = bounds_;
  const std::vector<std::int32_t> values = std::move(values_);
  bounds_ = grown(before, wanted);
  values_.assign(
      static_cast<std::size_t>(bounds_.columns()) * static_cast<std::size_t>(bounds_.rows()), 0);
  auto row = values.begin();
  for (std::int32_t y = before.min.y; y <= before.max.y; ++y) {
    std::copy(row,
              row + before.columns(),
              values_.begin() + static_cast<std::ptrdiff_t>(bounds_.index({before.min.x, y})));
    row += before.columns();
  }
}

}  // namespace echomap::mapping
