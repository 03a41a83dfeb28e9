// SPDX-License-Identifier: MIT
#include "hil_mock/world/ray_cast.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

TEST(RayCast, MeetsTheNearestWallAtItsIncidence) {
  const FloorPlan plan = box_room({{rectangle(3.0, 1.0, 3.2, 2.0), {}}});
  const auto straight = cast_ray(plan, {2.0, 1.5}, {1.0, 0.0});
  ASSERT_TRUE(straight);
  EXPECT_DOUBLE_EQ(straight->distance_m, 1.0);
  EXPECT_NEAR(straight->incidence_rad, 0.0, 1e-7);
  const auto slanted = cast_ray(plan, {2.0, 1.5}, {0.6, 0.8});
  ASSERT_TRUE(slanted);
  EXPECT_DOUBLE_EQ(slanted->distance_m, 1.5 / 0.8);
  EXPECT_NEAR(slanted->incidence_rad, std::acos(0.8), 1e-7);
}

TEST(RayCast, LeavesTheWallThatItStartsOn) {
  const auto hit = cast_ray(box_room(), {4.0, 1.5}, {-1.0, 0.0});
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->distance_m, 4.0);
}

TEST(RayCast, AWallHidesWhatIsBehindIt) {
  const FloorPlan plan = box_room({{rectangle(3.0, 1.0, 3.2, 2.0), {}}});
  EXPECT_FALSE(sees(plan, {2.0, 1.5}, {3.8, 1.5}));
  EXPECT_TRUE(sees(plan, {2.0, 1.5}, {3.8, 2.9}));
  EXPECT_TRUE(sees(plan, {2.0, 1.5}, {3.0, 1.5}));
}

}  // namespace
}  // namespace echomap::world
