// SPDX-License-Identifier: MIT
#include "hil_mock/world/floor_contact.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

/// No floor right of x = 3.
FloorPlan room_with_stairs() {
  return {"stairs",
          {rectangle(0.0, 0.0, 4.0, 3.0), {}},
          {},
          {2.0, 1.5, 0.0},
          {{rectangle(3.0, 0.0, 4.0, 3.0)}, {}}};
}

TEST(FloorContact, AWheelHangsWhereItsPointOfContactIsOverAHole) {
  const FloorPlan plan = room_with_stairs();
  const double half_turn_rad = std::numbers::pi / 2.0;
  const WheelSupport before = wheel_support(plan, {2.95, 1.5, half_turn_rad}, 0.14);
  EXPECT_TRUE(before.left);
  EXPECT_FALSE(before.right);
  const WheelSupport beyond = wheel_support(plan, {3.1, 1.5, half_turn_rad}, 0.14);
  EXPECT_FALSE(beyond.left);
  EXPECT_FALSE(beyond.right);
}

TEST(FloorContact, ACliffSensorLooksDownAtItsMount) {
  const FloorPlan plan = room_with_stairs();
  const CliffParams sensor{CliffPlace::kFrontLeft, {0.08, 0.03}};
  EXPECT_FALSE(cliff_under(plan, {2.91, 1.5, 0.0}, sensor));
  EXPECT_TRUE(cliff_under(plan, {2.93, 1.5, 0.0}, sensor));
  EXPECT_FALSE(cliff_under(plan, {2.93, 1.5, std::numbers::pi}, sensor)) << "it looks away";
}

TEST(FloorContact, DistanceIsToTheEdgeOfTheNearestHole) {
  EXPECT_DOUBLE_EQ(hole_distance_m(room_with_stairs(), {2.6, 1.5}), 0.4);
  EXPECT_TRUE(std::isinf(hole_distance_m(box_room(), {2.0, 1.5})));
}

}  // namespace
}  // namespace echomap::world
