// SPDX-License-Identifier: MIT
#include "host/mapping/cell_field.hpp"

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

TEST(CellField, FindsEachCellAgainByItsIndex) {
  CellField field({{-3, -2}, {4, 5}}, 0.1);
  EXPECT_EQ(field.size(), 64U);
  for (std::size_t i = 0; i < field.size(); ++i) {
    EXPECT_TRUE(field.holds(field.cell(i)));
    EXPECT_EQ(field.index(field.cell(i)), i);
    EXPECT_EQ(field.cell_at(field.center_m(field.cell(i))), field.cell(i));
  }
  EXPECT_FALSE(field.holds({5, 0}));
  EXPECT_FALSE(field.holds({0, -3}));
}

TEST(CellField, BeginsWithZerosAndCanGoBackToThem) {
  CellField field({{0, 0}, {1, 1}}, 0.1);
  EXPECT_EQ(field[3], 0.0F);
  field[3] = 2.0F;
  field.clear();
  EXPECT_EQ(field[3], 0.0F);
}

}  // namespace
}  // namespace echomap::mapping
