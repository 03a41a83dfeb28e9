// SPDX-License-Identifier: MIT
#include "host/exploration/covered_ground.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::exploration {
namespace {

const geometry::Polygon square{{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}};

TEST(CoveredGround, CoversWhatIsWithinReach) {
  CoveredGround ground(0.07, 0.02);
  ground.cover({0.5, 0.5});
  EXPECT_TRUE(ground.is_covered({0.55, 0.5}));
  EXPECT_FALSE(ground.is_covered({0.6, 0.5}));
}

TEST(CoveredGround, LeavesTheNearestFloorBesideWhatIsCovered) {
  CoveredGround ground(0.07, 0.02);
  EXPECT_FALSE(ground.nearest_left_m({0.0, 0.0}));
  ground.cover({0.5, 0.5});
  const auto left_m = ground.nearest_left_m({0.9, 0.5});
  ASSERT_TRUE(left_m);
  EXPECT_NEAR(left_m->x(), 0.58, 0.02);
  EXPECT_NEAR(left_m->y(), 0.50, 0.03);
}

TEST(CoveredGround, LeavesNothingBehindTheWallsOfTheRoomNorInAnIsland) {
  CoveredGround ground(0.07, 0.02);
  ground.add({square, false});
  EXPECT_TRUE(ground.knows_the_room());
  ground.add({{{0.4, 0.4}, {0.4, 0.6}, {0.6, 0.6}, {0.6, 0.4}}, true});
  for (double x_m = 0.1; x_m < 0.91; x_m += 0.02) {
    for (double y_m = 0.1; y_m < 0.91; y_m += 0.02) {
      if (x_m < 0.38 || x_m > 0.62 || y_m < 0.38 || y_m > 0.62) {
        ground.cover({x_m, y_m});
      }
    }
  }
  EXPECT_FALSE(ground.nearest_left_m({0.5, 0.5}));
}

TEST(CoveredGround, DoesNotNameAgainWhatWasGivenUp) {
  CoveredGround ground(0.07, 0.02);
  ground.cover({0.5, 0.5});
  const auto first_m = ground.nearest_left_m({0.9, 0.5});
  ground.give_up(*first_m);
  EXPECT_GT((*ground.nearest_left_m({0.9, 0.5}) - *first_m).norm(), 0.01);
}

TEST(CoveredGround, RefusesSizesWithoutSense) {
  EXPECT_THROW(CoveredGround(0.0, 0.02), std::invalid_argument);
  EXPECT_THROW(CoveredGround(0.07, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
