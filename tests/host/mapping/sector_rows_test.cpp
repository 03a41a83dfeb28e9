// SPDX-License-Identifier: MIT
#include "host/mapping/sector_rows.hpp"

#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

std::vector<Wedge> wedges(double axis_rad, const std::vector<double>& half_openings_rad) {
  std::vector<Wedge> wedges;
  for (const double half_rad : half_openings_rad) {
    wedges.emplace_back(geometry::unit_vector(axis_rad), geometry::unit_vector(half_rad));
  }
  return wedges;
}

bool holds(const RowColumns& columns, std::int32_t row, std::int32_t x) {
  return x >= -columns.minus_from[row] && x < -columns.minus_to[row];
}

/// Rows from the top down, columns -6 to 6: in how many wedges a cell is, and 'o' in the hole.
std::string drawing_of(const SectorRows& rows, std::size_t wedges) {
  std::string drawn;
  for (std::int32_t y = rows.bounds().max.y; y >= rows.bounds().min.y; --y) {
    for (std::int32_t x = -6; x <= 6; ++x) {
      int within = 0;
      for (std::size_t i = 0; i < wedges; ++i) {
        within += holds(rows.wedge(i, y), 0, x) ? 1 : 0;
      }
      const bool is_cut = rows.has_hole() && holds(rows.hole(y), 0, x);
      drawn += within == 0 ? "." : is_cut ? "o" : std::to_string(within);
    }
    drawn += '\n';
  }
  return drawn;
}

TEST(SectorRows, LaysWedgesOutWithinTheRim) {
  SectorRows rows(2, 6);
  rows.lay_out(wedges(0.0, {0.7, 0.35}), {-1, 36});
  EXPECT_EQ(drawing_of(rows, 2),
            "..........11.\n"
            ".........111.\n"
            "........1222.\n"
            "......2222222\n"
            "........1222.\n"
            ".........111.\n"
            "..........11.\n");
  EXPECT_EQ(rows.bounds().min, (geometry::CellIndex{0, -3}));
  EXPECT_EQ(rows.bounds().max, (geometry::CellIndex{6, 3}));
}

TEST(SectorRows, LeavesTheHoleOut) {
  SectorRows rows(1, 6);
  rows.lay_out(wedges(std::numbers::pi / 2.0, {0.8}), {16, 36});
  EXPECT_EQ(drawing_of(rows, 1),
            "......1......\n"
            "...1111111...\n"
            "..1111o1111..\n"
            "...1ooooo1...\n");
}

TEST(SectorRows, FindsTheRowsOfSomeColumns) {
  SectorRows rows(1, 6);
  rows.lay_out(wedges(0.0, {0.7}), {-1, 36});
  EXPECT_EQ(rows.rows_in({-6, 2}).first, -1);
  EXPECT_EQ(rows.rows_in({4, 9}).last, 3);
  EXPECT_GT(rows.rows_in({-9, -1}).first, rows.rows_in({-9, -1}).last);
  EXPECT_GT(rows.rows_in({7, 20}).first, rows.rows_in({7, 20}).last);
}

TEST(SectorRows, HoldsTheCellsOfTheDisc) {
  for (const std::int32_t square : {0, 1, 24, 25, 26, 3600, 3'999'999, 4'000'000}) {
    SectorRows rows(1, 2000);
    rows.lay_out(wedges(0.0, {1.5}), {-1, square});
    for (std::int32_t y = rows.bounds().min.y; y <= rows.bounds().max.y; ++y) {
      const std::int32_t last = -rows.wedge(0, y).minus_to[0] - 1;
      ASSERT_LE(last * last + y * y, square) << square << ' ' << y;
      ASSERT_GT((last + 1) * (last + 1) + y * y, square) << square << ' ' << y;
    }
  }
}

}  // namespace
}  // namespace echomap::mapping
