// SPDX-License-Identifier: MIT
#include "host/geometry/polygon.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::geometry {
namespace {

// An L, in cells of 1 m.
const Polygon drawn_l = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 1.0}, {2.0, 1.0}, {2.0, 3.0}, {0.0, 3.0}};

/// Counter-clockwise from the lower left corner.
Polygon rectangle(double left_m, double bottom_m, double right_m, double top_m) {
  return {{left_m, bottom_m}, {right_m, bottom_m}, {right_m, top_m}, {left_m, top_m}};
}

TEST(Polygon, ContainsWhatIsDrawnInside) {
  const std::vector<std::string> drawn = {
      "......",
      ".##...",
      ".##...",
      ".####.",
      "......",
  };
  for (std::size_t row = 0; row < drawn.size(); ++row) {
    for (std::size_t column = 0; column < drawn[row].size(); ++column) {
      const Eigen::Vector2d point(static_cast<double>(column) - 0.5,
                                  3.5 - static_cast<double>(row));
      EXPECT_EQ(contains(drawn_l, point), drawn[row][column] == '#') << point.transpose();
    }
  }
}

TEST(Polygon, SidesBelongToNeitherSide) {
  EXPECT_FALSE(contains(drawn_l, Eigen::Vector2d(0.0, 1.0)));
  EXPECT_FALSE(contains(drawn_l, Eigen::Vector2d(2.0, 1.0)));
  EXPECT_FALSE(contains(drawn_l, Eigen::Vector2d(3.0, 1.0)));
}

TEST(Polygon, AreaTellsTheSense) {
  EXPECT_DOUBLE_EQ(signed_area_m2(drawn_l), 8.0);
  EXPECT_DOUBLE_EQ(signed_area_m2({drawn_l.rbegin(), drawn_l.rend()}), -8.0);
}

TEST(Polygon, HoldsAnInnerPolygonThatTouchesButNotOneThatCrosses) {
  EXPECT_TRUE(contains(drawn_l, rectangle(0.0, 0.0, 1.0, 3.0)));
  EXPECT_FALSE(contains(drawn_l, rectangle(1.0, 0.5, 3.0, 0.5 + 1.0)));
  EXPECT_FALSE(contains(drawn_l, rectangle(5.0, 0.0, 6.0, 1.0)));
}

TEST(Polygon, NamesItsFault) {
  EXPECT_EQ(polygon_fault(drawn_l), std::nullopt);
  EXPECT_EQ(polygon_fault({{0.0, 0.0}, {1.0, 0.0}}),
            "a polygon needs at least 3 corners, here are 2");
  EXPECT_EQ(polygon_fault({{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}}), "sides 0 and 2 cross");
  EXPECT_EQ(polygon_fault({{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}),
            "corners 1 and 2 are the same");
  EXPECT_EQ(polygon_fault({{0.0, 0.0}, {2.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}),
            "sides 0 and 1 lie on each other");
}

}  // namespace
}  // namespace echomap::geometry
