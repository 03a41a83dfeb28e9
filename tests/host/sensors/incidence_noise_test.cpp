// SPDX-License-Identifier: MIT
#include "host/sensors/incidence_noise.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::sensors {
namespace {

using geometry::degrees;
using geometry::radians;

SweptWall wall_with(std::vector<WallReading> heard) {
  SweptWall wall;
  wall.heard = std::move(heard);
  return wall;
}

TEST(IncidenceNoise, IsOfAllWallsInStepsOfTheAngle) {
  const std::vector<SweptWall> walls{
      wall_with({{radians(2.0), 0.01}, {radians(35.0), 0.05}}),
      wall_with({{radians(9.0), 0.03}, {radians(3.0), 0.02}}),
  };
  const auto rows = noise_by_incidence(walls, radians(10.0));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_NEAR(degrees(rows[0].from_rad), 0.0, 1e-9);
  EXPECT_NEAR(degrees(rows[0].to_rad), 10.0, 1e-9);
  EXPECT_EQ(rows[0].readings, 3U);
  EXPECT_NEAR(rows[0].bias_m, 0.02, 1e-12);
  EXPECT_NEAR(rows[0].stddev_m, 0.01, 1e-12);
  EXPECT_NEAR(degrees(rows[1].from_rad), 30.0, 1e-9);
  EXPECT_EQ(rows[1].readings, 1U);
  EXPECT_EQ(rows[1].stddev_m, 0.0);
}

TEST(IncidenceNoise, OfNothingIsNothing) {
  EXPECT_TRUE(noise_by_incidence({}, 0.1).empty());
  EXPECT_THROW(noise_by_incidence({}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::sensors
