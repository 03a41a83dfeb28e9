// SPDX-License-Identifier: MIT
#include "host/mapping/row_minima.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

std::vector<std::int32_t> one_by_one(const std::vector<std::int32_t>& heights,
                                     std::int32_t first,
                                     std::size_t count) {
  std::vector<std::int32_t> minima(count, std::numeric_limits<std::int32_t>::max());
  for (std::size_t k = 0; k < count; ++k) {
    const std::int32_t x = first + static_cast<std::int32_t>(k);
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(heights.size()); ++i) {
      const std::int32_t value = heights[static_cast<std::size_t>(i)] + (x - i) * (x - i);
      minima[k] = std::min(minima[k], value);
    }
  }
  return minima;
}

TEST(RowMinima, AreThoseOfALoopOverAll) {
  std::mt19937 random(23);
  for (const std::size_t length : {1U, 2U, 15U, 16U, 17U, 255U, 256U, 257U, 900U, 4500U}) {
    for (const std::uint32_t highest : {1U, 30U, 5000U, 1'000'000U, 1U << 30U}) {
      std::vector<std::int32_t> heights(length);
      for (std::int32_t& height : heights) {
        height = static_cast<std::int32_t>(random() % highest);
      }
      const auto first = static_cast<std::int32_t>(random() % length);
      const std::size_t count = length - static_cast<std::size_t>(first);
      const auto expected = one_by_one(heights, first, count);
      std::vector<std::int32_t> minima(count);
      row_minima(heights, first, minima);
      ASSERT_EQ(minima, expected) << length << ' ' << highest;
    }
  }
}

TEST(RowMinima, ReachTheEndsOfTheLongestRow) {
  std::vector<std::int32_t> heights(kMaxRowCells, 1 << 30);
  heights.front() = 0;
  std::vector<std::int32_t> minima(kMaxRowCells);
  row_minima(heights, 0, minima);
  EXPECT_EQ(minima.front(), 0);
  EXPECT_EQ(minima.back(), (kMaxRowCells - 1) * (kMaxRowCells - 1));
}

TEST(RowMinima, AreTheSameFromNearbyWhereTheyAreBelowTheReachSquared) {
  std::mt19937 random(29);
  for (const std::int32_t reach : {1, 7, 40, kMaxNearReach}) {
    for (const std::size_t count : {1U, 31U, 32U, 33U, 200U}) {
      const auto margin = static_cast<std::size_t>(reach);
      const std::int32_t most = reach * reach;
      std::vector<std::int32_t> heights(count + 2 * margin, most);
      for (std::int32_t& height : heights) {
        const auto lower =
            static_cast<std::int32_t>(random() % (static_cast<std::uint32_t>(most) + 1));
        height = random() % 8 == 0 ? lower : most;
      }
      std::vector<std::uint16_t> squares(heights.begin(), heights.end());
      squares.resize(squares.size() + kNearPadding);
      const auto expected = one_by_one(heights, reach, count);
      std::vector<std::uint16_t> minima(count);
      near_row_minima(squares, reach, minima);
      for (std::size_t x = 0; x < count; ++x) {
        ASSERT_EQ(std::min<std::int32_t>(minima[x], most), std::min(expected[x], most))
            << reach << ' ' << count << ' ' << x;
      }
    }
  }
}

}  // namespace
}  // namespace echomap::mapping
