// SPDX-License-Identifier: MIT
#include "host/mapping/wall_distance.hpp"

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::mapping {
namespace {

TEST(WallDistance, IsThatToTheNearestOccupiedCellAlsoBetweenCentres) {
  const WallDistance distance(tests::map_from({"....", "#...", "...."}, 0.1), 0.5);
  EXPECT_NEAR(distance.at_m({0.05, 0.15}), 0.0, 1e-6);
  EXPECT_NEAR(distance.at_m({0.35, 0.15}), 0.3, 1e-6);
  EXPECT_NEAR(distance.at_m({0.20, 0.15}), 0.15, 1e-6);
  EXPECT_NEAR(distance.at_m({-0.15, 0.15}), 0.2, 1e-6) << "beside the map";
}

TEST(WallDistance, IsNoMoreThanTheMost) {
  const WallDistance distance(tests::map_from({"#........."}, 0.1), 0.5);
  EXPECT_NEAR(distance.at_m({0.95, 0.05}), 0.5, 1e-6);
  EXPECT_NEAR(distance.at_m({30.0, -7.0}), 0.5, 1e-6);
}

}  // namespace
}  // namespace echomap::mapping
