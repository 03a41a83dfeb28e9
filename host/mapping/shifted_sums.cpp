// SPDX-License-Identifier: MIT
#include "host/mapping/shifted_sums.hpp"

#include <algorithm>

namespace echomap::mapping {
namespace {

/// sums[i] += numbers[i]
void add(const float* numbers, int count, float* sums) {
  for (int i = 0; i < count; ++i) {
    sums[i] += numbers[i];
  }
}

}  // namespace

ShiftedSums::ShiftedSums(const std::vector<float>& numbers, int columns)
    : rows_(static_cast<int>(numbers.size()) / columns), half_columns_((columns + 1) / 2) {
  for (int half = 0; half < 2; ++half) {
    auto& of_half = halves_[static_cast<std::size_t>(half)];
    of_half.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(half_columns_), 0.0F);
    for (int y = 0; y < rows_; ++y) {
      for (int x = half; x < columns; x += 2) {
        const std::ptrdiff_t to = std::ptrdiff_t{y} * half_columns_ + x / 2;
        const std::ptrdiff_t from = std::ptrdiff_t{y} * columns + x;
        of_half[static_cast<std::size_t>(to)] = numbers[static_cast<std::size_t>(from)];
      }
    }
  }
}

std::vector<float> ShiftedSums::over(const std::vector<geometry::CellIndex>& cells,
                                     const EvenShifts& shifts) const {
  std::vector<float> sums(
      static_cast<std::size_t>(shifts.columns) * static_cast<std::size_t>(shifts.rows), 0.0F);
  for (const geometry::CellIndex& cell : cells) {
    const std::int32_t x = cell.x + shifts.first.x;
    const std::int32_t half = x & 1;
    const std::int32_t left = (x - half) / 2;
    const std::int32_t begin = std::max(0, -left);
    const std::int32_t count = std::min(shifts.columns, half_columns_ - left) - begin;
    for (int row = 0; row < shifts.rows; ++row) {
      const std::int32_t y = cell.y + shifts.first.y + 2 * row;
      if (count > 0 && y >= 0 && y < rows_) {
        add(halves_[static_cast<std::size_t>(half)].data() + (y * half_columns_ + left + begin),
            count,
            sums.data() + (row * shifts.columns + begin));
      }
    }
  }
  return sums;
}

}  // namespace echomap::mapping
