// SPDX-License-Identifier: MIT
#include "host/slam/surface_field.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

using Eigen::Vector2d;

/// Points every 2 cm along y = 1.07 m, from x = 0 to 2 m.
std::vector<Vector2d> wall_m() {
  std::vector<Vector2d> points_m;
  for (int i = 0; i <= 100; ++i) {
    points_m.emplace_back(0.02 * i, 1.07);
  }
  return points_m;
}

Surface surface_at(SurfaceField& field, const Vector2d& point_m, int level) {
  return field.surface_at(field.cell_at(point_m, level), level);
}

TEST(SurfaceField, PlacesAWallFinerThanItsCells) {
  SurfaceField field;
  field.add(wall_m());
  for (int level = 0; level < SurfaceField::kLevels; ++level) {
    EXPECT_NEAR(surface_at(field, {1.0, 1.0}, level).mean_m.y(), 1.07, 1e-9) << level;
  }
}

TEST(SurfaceField, AWallSaysNothingAlongItself) {
  SurfaceField field;
  field.add(wall_m());
  const Surface surface = surface_at(field, {1.0, 1.0}, 0);
  EXPECT_NEAR(surface.information_xx, 0.0, 1e-6);
  EXPECT_NEAR(surface.information_xy, 0.0, 1e-6);
  EXPECT_NEAR(surface.information_yy, 1.0 / (0.03 * 0.03), 1.0);
}

TEST(SurfaceField, PointsInAClusterDoNotTellHowTheirSurfaceLies) {
  SurfaceField field;
  field.add(std::vector<Vector2d>{{1.0, 1.0}, {1.01, 1.0}, {1.0, 1.01}, {1.01, 1.01}});
  EXPECT_TRUE(surface_at(field, {1.0, 1.0}, 0).empty());
}

TEST(SurfaceField, AsksCoarserCellsWherePointsAreFew) {
  SurfaceField field;
  field.add(std::vector<Vector2d>{{0.05, 0.05}, {0.55, 0.05}, {1.05, 0.05}});
  EXPECT_FALSE(surface_at(field, {0.5, 0.1}, 0).empty()) << "only the coarsest cells hold three";
  EXPECT_NEAR(surface_at(field, {0.5, 0.1}, 0).mean_m.x(), 0.55, 1e-9);
  EXPECT_TRUE(surface_at(field, {9.0, 9.0}, 0).empty());
}

TEST(SurfaceField, FollowsPointsThatComeLater) {
  SurfaceField field;
  field.add(wall_m());
  ASSERT_NEAR(surface_at(field, {1.0, 1.0}, 0).mean_m.y(), 1.07, 1e-9);
  auto moved_m = wall_m();
  for (Vector2d& point_m : moved_m) {
    point_m.y() += 0.02;
  }
  field.add(moved_m);
  EXPECT_NEAR(surface_at(field, {1.0, 1.0}, 0).mean_m.y(), 1.08, 1e-9);
  field.clear();
  EXPECT_TRUE(field.empty());
  EXPECT_TRUE(surface_at(field, {1.0, 1.0}, 0).empty());
}

TEST(SurfaceField, RefusesParametersWithoutSense) {
  EXPECT_THROW(SurfaceField({0.0, 0.03, 3}), std::invalid_argument);
  EXPECT_THROW(SurfaceField({0.1, 0.0, 3}), std::invalid_argument);
  EXPECT_THROW(SurfaceField({0.1, 0.03, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
