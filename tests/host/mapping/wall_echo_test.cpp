// SPDX-License-Identifier: MIT
#include "host/mapping/wall_echo.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

/// A wall at x = 2, seen from the origin.
const WallLine kWallAtTwo{0.0, 2.0};

TEST(WallView, IsTheFootOfThePerpendicularAsLongAsThatIsInTheBeam) {
  const WallView view = view_of_wall({{0.0, 0.0}, radians(10.0), 0.0, radians(15.0)}, kWallAtTwo);
  EXPECT_NEAR(view.range_m, 2.0, 1e-12);
  EXPECT_NEAR(view.contact_rad, 0.0, 1e-12);
}

TEST(WallView, IsAtTheBeamsEdgeWhereTheFootIsOutside) {
  const WallView view = view_of_wall({{0.0, 0.0}, radians(40.0), 0.0, radians(10.0)}, kWallAtTwo);
  EXPECT_NEAR(view.contact_rad, radians(30.0), 1e-12);
  EXPECT_NEAR(view.range_m, 2.0 / std::cos(radians(30.0)), 1e-12);
}

TEST(WallView, OfAThinBeamIsWhereItMeetsTheWall) {
  const WallView view = view_of_wall({{0.5, 0.3}, radians(-60.0), 0.0, 0.0}, kWallAtTwo);
  EXPECT_NEAR(view.range_m, 1.5 / std::cos(radians(60.0)), 1e-12);
}

TEST(WallView, OfTheWallThroughAnEchoIsThatEcho) {
  for (const double normal_deg : {-40.0, 0.0, 12.0, 35.0}) {
    const Echo echo{{0.4, -0.3}, radians(5.0), 1.7, radians(12.0)};
    EXPECT_NEAR(view_of_wall(echo, wall_through(echo, radians(normal_deg))).range_m, 1.7, 1e-12);
  }
}

TEST(WallView, ChangesWithTheWallAsItsDerivativesSay) {
  constexpr double kStep = 1e-6;
  for (const double axis_deg : {-50.0, -20.0, 5.0, 35.0, 60.0}) {
    const Echo echo{{0.4, -0.3}, radians(axis_deg), 0.0, radians(12.0)};
    const WallLine line{0.1, 2.0};
    const double range_m = view_of_wall(echo, line).range_m;
    const Eigen::Vector2d by_line = view_of_wall(echo, line).by_line;
    const double turned_m = view_of_wall(echo, {0.1 + kStep, 2.0}).range_m;
    const double moved_m = view_of_wall(echo, {0.1, 2.0 + kStep}).range_m;
    EXPECT_NEAR(by_line[0], (turned_m - range_m) / kStep, 1e-4) << axis_deg;
    EXPECT_NEAR(by_line[1], (moved_m - range_m) / kStep, 1e-4) << axis_deg;
  }
}

}  // namespace
}  // namespace echomap::mapping
