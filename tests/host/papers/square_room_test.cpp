// SPDX-License-Identifier: MIT
#include "host/papers/square_room.hpp"

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::papers {
namespace {

TEST(SquareRoom, IsSweptInSteps) {
  const auto readings = sweep(square_room(),
                              ev3_sonar(geometry::radians(32.8)),
                              {geometry::radians(90.0), geometry::radians(10.0)},
                              1);
  ASSERT_EQ(readings.size(), 18U);
  EXPECT_NEAR(readings.front().bearing_rad, geometry::radians(-90.0), 1e-9);
  EXPECT_NEAR(readings.front().range_m.value(), 0.7, 0.05);
}

TEST(SquareRoom, HasWallsThatShowTheConesWidth) {
  for (const double width_deg : {20.0, 32.8}) {
    const auto walls = walls_of_room(square_room(), ev3_sonar(geometry::radians(width_deg)), 1);
    EXPECT_GE(walls.size(), 8U);
    const auto pooled = sensors::pooled_beam_width(walls);
    ASSERT_TRUE(pooled);
    EXPECT_NEAR(geometry::degrees(pooled->mean.beam_width_rad), width_deg, 3.0);
  }
}

}  // namespace
}  // namespace echomap::papers
