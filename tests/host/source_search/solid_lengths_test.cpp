// SPDX-License-Identifier: MIT
#include "host/source_search/solid_lengths.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::source_search {
namespace {

const tests::DrawnMap kWall = {
    "..........##..........",
    "..........##..........",
    "..........##..........",
    "..........##..........",
    "..........##..........",
};

TEST(SolidLengths, OpenFloorHasNone) {
  const SolidLengths lengths(tests::map_from(kWall));
  EXPECT_EQ(lengths.between_m({0.05, 0.02}, {0.45, 0.22}), 0.0);
}

TEST(SolidLengths, CountsAWallByItsThickness) {
  const SolidLengths lengths(tests::map_from(kWall));
  EXPECT_NEAR(lengths.between_m({0.1, 0.12}, {1.0, 0.12}), 0.1, 0.0126);
}

TEST(SolidLengths, CountsAWallThatIsCrossedAslant) {
  const SolidLengths lengths(tests::map_from(kWall));
  EXPECT_NEAR(lengths.between_m({0.46, 0.03}, {0.64, 0.21}), 0.1 * std::numbers::sqrt2, 0.03);
}

TEST(SolidLengths, IsTheSameToAndFro) {
  const SolidLengths lengths(tests::map_from(kWall));
  EXPECT_NEAR(lengths.between_m({0.1, 0.03}, {1.0, 0.2}),
              lengths.between_m({1.0, 0.2}, {0.1, 0.03}),
              0.0126);
}

TEST(SolidLengths, TakesWhatIsOutsideOfTheMapForAir) {
  const SolidLengths lengths(tests::map_from(kWall));
  EXPECT_NEAR(lengths.between_m({-2.0, 0.12}, {4.0, 0.12}), 0.1, 0.0126);
  EXPECT_EQ(lengths.between_m({-2.0, -1.0}, {4.0, -1.0}), 0.0);
}

TEST(SolidLengths, OfAPointIsNone) {
  const SolidLengths lengths(tests::map_from(kWall));
  EXPECT_EQ(lengths.between_m({0.52, 0.1}, {0.52, 0.1}), 0.0);
}

}  // namespace
}  // namespace echomap::source_search
