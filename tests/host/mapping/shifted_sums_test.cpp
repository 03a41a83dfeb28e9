// SPDX-License-Identifier: MIT
#include "host/mapping/shifted_sums.hpp"

#include <random>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

using geometry::CellIndex;

/// Cell by cell and shift by shift.
std::vector<float> plain_sums(const std::vector<float>& numbers,
                              int columns,
                              const std::vector<CellIndex>& cells,
                              const EvenShifts& shifts) {
  const int rows = static_cast<int>(numbers.size()) / columns;
  std::vector<float> sums;
  for (int j = 0; j < shifts.rows; ++j) {
    for (int i = 0; i < shifts.columns; ++i) {
      float sum = 0.0F;
      for (const CellIndex& cell : cells) {
        const int x = cell.x + shifts.first.x + 2 * i;
        const int y = cell.y + shifts.first.y + 2 * j;
        const bool is_inside = x >= 0 && y >= 0 && x < columns && y < rows;
        sum += is_inside ? numbers[static_cast<std::size_t>(y * columns + x)] : 0.0F;
      }
      sums.push_back(sum);
    }
  }
  return sums;
}

TEST(ShiftedSums, AreThoseOfEveryShiftToTheLastBit) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> number(-2.0F, 1.0F);
  std::uniform_int_distribution<int> place(-9, 9);
  for (const int columns : {1, 2, 7, 12}) {
    std::vector<float> numbers(static_cast<std::size_t>(columns) * 9);
    for (float& one : numbers) {
      one = number(random);
    }
    std::vector<CellIndex> cells;
    for (int i = 0; i < 20; ++i) {
      cells.push_back({place(random), place(random)});
    }
    const ShiftedSums sums(numbers, columns);
    for (const EvenShifts& shifts :
         {EvenShifts{{-10, -11}, 16, 15}, EvenShifts{{-7, -4}, 3, 2}, EvenShifts{{40, 40}, 2, 2}}) {
      EXPECT_EQ(sums.over(cells, shifts), plain_sums(numbers, columns, cells, shifts))
          << columns << " from " << shifts.first.x;
    }
  }
}

TEST(ShiftedSums, AreZeroOverNoCells) {
  const ShiftedSums sums({1.0F, 2.0F}, 2);
  EXPECT_EQ(sums.over({}, {{0, 0}, 2, 1}), (std::vector<float>{0.0F, 0.0F}));
}

TEST(ShiftedSums, TakeEverySecondCell) {
  const ShiftedSums sums({1.0F, 2.0F, 3.0F, 4.0F, 5.0F}, 5);
  EXPECT_EQ(sums.over({{0, 0}}, {{0, 0}, 3, 1}), (std::vector<float>{1.0F, 3.0F, 5.0F}));
  EXPECT_EQ(sums.over({{0, 0}}, {{-1, 0}, 4, 1}), (std::vector<float>{0.0F, 2.0F, 4.0F, 0.0F}));
}

}  // namespace
}  // namespace echomap::mapping
