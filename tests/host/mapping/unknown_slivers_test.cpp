// SPDX-License-Identifier: MIT
#include "host/mapping/unknown_slivers.hpp"

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::mapping {
namespace {

using tests::drawing_of;
using tests::DrawnMap;
using tests::map_from;

DrawnMap filled(const DrawnMap& drawing, double width_m) {
  return drawing_of(without_unknown_slivers(map_from(drawing), width_m));
}

TEST(UnknownSlivers, AreFloorAndWiderPiecesStay) {
  const DrawnMap drawing{"..........", ".   . ....", ".   .  ...", ".   . ....", ".........."};
  const DrawnMap wide{"..........", ".   ......", ".   ......", ".   ......", ".........."};
  EXPECT_EQ(filled(drawing, 0.15), wide);
  EXPECT_EQ(filled(drawing, 0.20), DrawnMap(5, ".........."));
}

TEST(UnknownSlivers, CutAPatchOffTheWallThatItTouchesByItsTip) {
  const DrawnMap drawing{"........", ".    ...", ".    ...", ".    ...", "..  ....", "########"};
  const DrawnMap cut{"........", ".    ...", ".    ...", ".    ...", "........", "########"};
  EXPECT_EQ(filled(drawing, 0.15), cut);
}

TEST(UnknownSlivers, AreNotOfTheUnknownBehindWallsAndBeyondTheMap) {
  const DrawnMap drawing{"......", "######", "      "};
  EXPECT_EQ(filled(drawing, 0.15), drawing);
  const DrawnMap edges{" ... ", " ... "};
  EXPECT_EQ(filled(edges, 0.15), edges);
}

TEST(UnknownSlivers, AreNeverOccupiedCells) {
  const DrawnMap drawing{".....", "..#..", "....."};
  EXPECT_EQ(filled(drawing, 0.15), drawing);
}

TEST(UnknownSlivers, OfNoWidthAreNone) {
  const DrawnMap drawing{"...", ". .", "..."};
  EXPECT_EQ(filled(drawing, 0.0), drawing);
}

}  // namespace
}  // namespace echomap::mapping
