// SPDX-License-Identifier: MIT
#include "host/slam/surface_patch.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::slam {
namespace {

using mapping::Echo;
using mapping::view_of_wall;

using geometry::radians;

/// Echoes of the wall x = 2 by a sensor that drives along x = 0, looking there at a slant.
std::vector<Echo> drive_by(double axis_rad, double beam_half_angle_rad) {
  std::vector<Echo> echoes;
  for (double y_m = 0.0; y_m < 1.0; y_m += 0.1) {
    Echo echo{{0.0, y_m}, axis_rad, 0.0, beam_half_angle_rad};
    echo.range_m = view_of_wall(echo, {0.0, 2.0}).range_m;
    echoes.push_back(echo);
  }
  return echoes;
}

void expect_on_wall(const std::vector<SurfacePatch>& patches) {
  ASSERT_GE(patches.size(), 2U);
  for (const SurfacePatch& patch : patches) {
    EXPECT_NEAR(patch.point_m.x(), 2.0, 0.01);
    EXPECT_NEAR(patch.normal_rad, 0.0, radians(2.0));
    EXPECT_LT(patch.offset_stddev_m, 0.03);
  }
}

TEST(SurfacePatches, OfThinBeamsLieOnTheWall) {
  expect_on_wall(find_patches(drive_by(radians(30.0), 0.0), {}));
}

TEST(SurfacePatches, OfConesLieOnTheWallAndNotOnTheirAxes) {
  expect_on_wall(find_patches(drive_by(radians(30.0), radians(10.0)), {}));
}

TEST(SurfacePatches, OfAPannedSonarStandAtTheFootOfThePerpendicular) {
  std::vector<Echo> echoes;
  for (int degree = -30; degree <= 30; degree += 3) {
    Echo echo{{0.0, 0.0}, radians(degree), 0.0, radians(13.0)};
    echo.range_m = view_of_wall(echo, {radians(5.0), 1.5}).range_m;
    echoes.push_back(echo);
  }
  const auto patches = find_patches(echoes, {});
  ASSERT_FALSE(patches.empty());
  for (const SurfacePatch& patch : patches) {
    EXPECT_NEAR(patch.normal_rad, radians(5.0), radians(2.0));
  }
}

TEST(SurfacePatches, AreNotFoundInClutter) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> range_m(0.5, 3.0);
  std::vector<Echo> echoes;
  for (int i = 0; i < 60; ++i) {
    echoes.push_back({{0.0, 0.01 * i}, radians(6.0 * i), range_m(random), radians(7.5)});
  }
  EXPECT_LE(find_patches(echoes, {}).size(), 2U);
}

TEST(SurfacePatches, AreNotMadeOfOneEchoHeardAgainAndAgain) {
  const std::vector<Echo> echoes(20, Echo{{0.0, 0.0}, 0.0, 1.0, radians(15.0)});
  EXPECT_TRUE(find_patches(echoes, {}).empty());
}

TEST(SurfacePatches, ParametersWithoutSenseAreRefused) {
  SurfacePatchParams params;
  params.max_rms_m = 0.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
