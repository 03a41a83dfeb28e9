// SPDX-License-Identifier: MIT
#include "host/source_search/solid_lengths.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/source_world.hpp"

namespace echomap::source_search {
namespace {

const tests::DrawnMap kWall = {
    "..........##..........",
    "..........##..........",
    "..........##..........",
    "..........##..........",
    "..........##..........",
};

/// Where unknown cells are air.
SolidLengths lengths_in(const mapping::RasterMap& map) {
  return SolidLengths(map, exploration::CellValues<float>(map, 1.0F), 0.5);
}

TEST(SolidLengths, OpenFloorHasNone) {
  const SolidLengths lengths = lengths_in(tests::map_from(kWall));
  EXPECT_EQ(lengths.between({0.05, 0.02}, {0.45, 0.22}).solid_m, 0.0);
}

TEST(SolidLengths, CountsAWallByItsThickness) {
  const SolidLengths lengths = lengths_in(tests::map_from(kWall));
  EXPECT_NEAR(lengths.between({0.1, 0.12}, {1.0, 0.12}).solid_m, 0.1, 0.0126);
}

TEST(SolidLengths, CountsAWallThatIsCrossedAslant) {
  const SolidLengths lengths = lengths_in(tests::map_from(kWall));
  EXPECT_NEAR(lengths.between({0.46, 0.03}, {0.64, 0.21}).solid_m, 0.1 * std::numbers::sqrt2, 0.03);
}

TEST(SolidLengths, IsTheSameToAndFro) {
  const SolidLengths lengths = lengths_in(tests::map_from(kWall));
  EXPECT_NEAR(lengths.between({0.1, 0.03}, {1.0, 0.2}).solid_m,
              lengths.between({1.0, 0.2}, {0.1, 0.03}).solid_m,
              0.0126);
}

TEST(SolidLengths, TakesWhatIsOutsideOfTheMapForAir) {
  const SolidLengths lengths = lengths_in(tests::map_from(kWall));
  EXPECT_NEAR(lengths.between({-2.0, 0.12}, {4.0, 0.12}).solid_m, 0.1, 0.0126);
  EXPECT_EQ(lengths.between({-2.0, -1.0}, {4.0, -1.0}).solid_m, 0.0);
}

TEST(SolidLengths, OfAPointIsNone) {
  const SolidLengths lengths = lengths_in(tests::map_from(kWall));
  EXPECT_EQ(lengths.between({0.52, 0.1}, {0.52, 0.1}).solid_m, 0.0);
}

TEST(SolidLengths, AConeIsClearOnlyWhereNoLineCrossesSolid) {
  const tests::SourceWorld world({6.0, 4.0}, {{{2.8, 1.8}, {3.2, 2.2}}});
  const SolidLengths lengths = lengths_in(world.map());
  EXPECT_TRUE(lengths.is_clear({1.0, 1.0}, {1.5, 3.0}, 0.4));
  EXPECT_FALSE(lengths.is_clear({1.0, 2.0}, {5.0, 2.0}, 0.1));
  EXPECT_FALSE(lengths.is_clear({1.0, 1.0}, {1.0, 3.9}, 0.4));
  std::mt19937 random(1);
  int clear = 0;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector2d from_m = world.sample_free(0.1, random);
    const Eigen::Vector2d middle_m = world.sample_free(0.1, random);
    if (!lengths.is_clear(from_m, middle_m, 0.3)) {
      continue;
    }
    ++clear;
    for (int bearing = 0; bearing < 12; ++bearing) {
      const Eigen::Vector2d edge_m =
          middle_m + 0.3 * geometry::unit_vector(geometry::radians(30.0 * bearing));
      EXPECT_EQ(world.solid_m(from_m, edge_m), 0.0);
    }
  }
  EXPECT_GT(clear, 50);
}

TEST(SolidLengths, UnknownCountsByHowLikelyItIsSolidBehindTheHollowOfTheSource) {
  const mapping::RasterMap map =
      tests::map_from({"....      ....", "....      ....", "....      ...."});
  const SolidLengths lengths(map, exploration::CellValues<float>(map, 0.2F), 0.1);
  // Of 10 cells of 5 cm.
  EXPECT_NEAR(lengths.between({0.025, 0.075}, {0.675, 0.075}).unknown_m, 0.8 * 0.3, 0.03);
  EXPECT_NEAR(lengths.between({0.025, 0.075}, {0.475, 0.075}).unknown_m, 0.8 * 0.2, 0.03);
  EXPECT_EQ(lengths.between({0.025, 0.075}, {0.675, 0.075}).solid_m, 0.0);
  EXPECT_TRUE(lengths.has_unknown());
}

}  // namespace
}  // namespace echomap::source_search
