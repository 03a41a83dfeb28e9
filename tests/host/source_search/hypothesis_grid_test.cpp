// SPDX-License-Identifier: MIT
#include "host/source_search/hypothesis_grid.hpp"

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::source_search {
namespace {

HypothesisGridParams params_with_leaves_of(double leaf_m) {
  HypothesisGridParams params;
  params.leaf_m = leaf_m;
  params.unknown_reach_m = 0.0;
  return params;
}

const tests::DrawnMap kFloor = {
    "    ....",
    "    ....",
    "    ##..",
    "    ....",
};

double area_of(const HypothesisGrid& grid) {
  double area_m2 = 0.0;
  for (const LeafBlock& block : grid.blocks()) {
    for (const double lane_m2 : block.area_m2) {
      area_m2 += lane_m2;
    }
  }
  return area_m2;
}

TEST(HypothesisGrid, NothingIsBehindOrDeepInAWall) {
  const tests::DrawnMap closed = {
      "              ",
      "  ##########  ",
      "  ##########  ",
      "  ##########  ",
      "  ###....###  ",
      "  ##########  ",
      "  ##########  ",
      "  ##########  ",
      "              ",
  };
  HypothesisGridParams params = params_with_leaves_of(0.1);
  params.unknown_reach_m = 1.0;
  params.solid_depth_m = 0.05;
  const HypothesisGrid grid(params, tests::map_from(closed));
  // 4 cells of floor and the 10 that share a side with one.
  EXPECT_NEAR(grid.area_m2(), 14 * 0.0025, 1e-9);
}

TEST(HypothesisGrid, PlacesAreTheKnownCells) {
  const HypothesisGrid grid(params_with_leaves_of(0.1), tests::map_from(kFloor));
  EXPECT_NEAR(grid.area_m2(), 16 * 0.0025, 1e-12);
  EXPECT_NEAR(area_of(grid), grid.area_m2(), 1e-12);
}

TEST(HypothesisGrid, UnknownCellsBesideFloorAreOnesToo) {
  HypothesisGridParams params = params_with_leaves_of(0.1);
  params.unknown_reach_m = 0.1;
  const HypothesisGrid grid(params, tests::map_from(kFloor));
  EXPECT_NEAR(grid.area_m2(), 24 * 0.0025, 2 * 0.0025);
}

TEST(HypothesisGrid, SplittingKeepsTheAreaAndTheReadings) {
  HypothesisGrid grid(params_with_leaves_of(0.2), tests::map_from(kFloor));
  const std::vector<FieldReading> readings{{{0.25, 0.1}, 5.0, 1.0, 0.0}};
  grid.add(readings);
  ASSERT_TRUE(grid.is_splittable({0, 0}));
  const std::vector<LeafIndex> all{{0, 0}};
  grid.split(all);
  ASSERT_EQ(grid.blocks().size(), 2U);
  EXPECT_NEAR(area_of(grid), grid.area_m2(), 1e-12);
  EXPECT_NE(grid.blocks()[1].lanes(0)[0], 0.0F);
  EXPECT_NE(grid.blocks()[1].lanes(0)[0], grid.blocks()[1].lanes(0)[1]);
}

TEST(HypothesisGrid, TheSmallestSquaresAreNotSplit) {
  HypothesisGrid grid(params_with_leaves_of(0.05), tests::map_from(kFloor));
  EXPECT_FALSE(grid.is_splittable({0, 0}));
  const std::vector<LeafIndex> all{{0, 0}};
  grid.split(all);
  EXPECT_EQ(grid.blocks().size(), 1U);
}

TEST(HypothesisGrid, NearReadingsAreOne) {
  HypothesisGrid grid(params_with_leaves_of(0.2), tests::map_from(kFloor));
  const std::vector<FieldReading> apart{{{0.30, 0.1}, 2.0, 1.0, 0.0}, {{0.31, 0.1}, 4.0, 3.0, 0.0}};
  grid.add(apart);
  ASSERT_EQ(grid.readings().size(), 1U);
  EXPECT_EQ(grid.readings()[0].value, 6.0);
  EXPECT_EQ(grid.readings()[0].dwell_s, 4.0);
  EXPECT_NEAR(grid.readings()[0].at_m.x(), 0.3075, 1e-12);

  HypothesisGrid at_once(params_with_leaves_of(0.2), tests::map_from(kFloor));
  at_once.add(grid.readings());
  for (std::size_t node = 0; node < grid.nodes().size(); ++node) {
    EXPECT_NEAR(grid.blocks()[0].lanes(node)[0], at_once.blocks()[0].lanes(node)[0], 1e-3);
  }
}

TEST(HypothesisGrid, OtherBackgroundsGiveTheirOwnLikelihoods) {
  HypothesisGrid grid(params_with_leaves_of(0.2), tests::map_from(kFloor));
  const std::vector<FieldReading> readings{{{0.25, 0.1}, 0.0, 2.0, 0.0}};
  grid.add(readings);
  grid.set_background_range(0.5, 2.0);
  ASSERT_NEAR(grid.nodes().backgrounds.front(), 0.5, 1e-6);
  ASSERT_NEAR(grid.nodes().backgrounds.back(), 2.0, 1e-6);
  // Without pulses the logarithm is minus the mean, but for the error of the background.
  EXPECT_NEAR(grid.none().front(), -1.0, 0.02);
  EXPECT_NEAR(grid.none().back(), -4.0, 0.2);
}

}  // namespace
}  // namespace echomap::source_search
