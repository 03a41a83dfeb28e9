// SPDX-License-Identifier: MIT
#include "host/exports/map_png.hpp"

#include <set>

#include <gtest/gtest.h>

#include "tests/support/png_picture.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exports {
namespace {

constexpr int kFloor = 0xFFFFFF;
constexpr int kWall = 0x282828;

/// 40 x 20 cells: floor with a wall on top.
mapping::OccupancyGrid hall() {
  mapping::OccupancyGrid grid;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 40; ++x) {
      grid.add({x, y}, y == 19 ? 300 : -300);
    }
  }
  return grid;
}

TEST(MapPng, HasTheTopOfTheMapOnTop) {
  const tests::ScratchFolder folder;
  write_map_png(folder / "map.png", tests::snapshot_of(hall()), std::nullopt);
  const tests::PngPicture picture(folder / "map.png");
  // One cell of margin, 8 pixels a cell, and two more cells for the robot in the corner.
  EXPECT_EQ(picture.width, 44 * 8);
  EXPECT_EQ(picture.at(160, 12), kWall);
  EXPECT_EQ(picture.at(160, 60), kFloor);
  EXPECT_NE(picture.at(160, 3), kFloor);
  EXPECT_NE(picture.at(160, 3), kWall);
}

TEST(MapPng, ShowsTheTrailFromStartToRobot) {
  const tests::ScratchFolder folder;
  std::vector<pipeline::StampedPose> trajectory;
  for (int i = 0; i <= 100; ++i) {
    trajectory.push_back(tests::pose_at(0.02 * i, {0.3 + 0.01 * i, 0.4, 0.0}));
  }
  write_map_png(folder / "map.png", tests::snapshot_of(hall(), trajectory), std::nullopt);
  const tests::PngPicture picture(folder / "map.png");
  const int row = 22 * 8 - 8 - static_cast<int>(0.4 / 0.05 * 8);
  const auto pixel = [&](double x_m) {
    return picture.at(8 + static_cast<int>(x_m / 0.05 * 8), row);
  };
  const std::set<int> marks{pixel(0.3 + 0.04), pixel(0.8), pixel(1.3 - 0.05)};
  EXPECT_EQ(marks.size(), 3U);
  EXPECT_EQ(marks.count(kFloor), 0U);
}

TEST(MapPng, CutsNoCornerOfTheTrail) {
  const tests::ScratchFolder folder;
  const std::vector<pipeline::StampedPose> trajectory{tests::pose_at(0, {0.2, 0.2, 0.0}),
                                                      tests::pose_at(1, {1.7, 0.2, 0.0}),
                                                      tests::pose_at(2, {1.7, 0.7, 0.0})};
  write_map_png(folder / "map.png", tests::snapshot_of(hall(), trajectory), std::nullopt);
  const tests::PngPicture picture(folder / "map.png");
  const auto pixel = [&](double x_m, double y_m) {
    return picture.at(8 + static_cast<int>(x_m / 0.05 * 8),
                      22 * 8 - 8 - static_cast<int>(y_m / 0.05 * 8));
  };
  EXPECT_EQ(pixel(1.7, 0.2), 0x0072B2);
  EXPECT_EQ(pixel(0.95, 0.45), kFloor);
}

TEST(MapPng, HasAScaleBarOfItsLength) {
  const tests::ScratchFolder folder;
  write_map_png(folder / "map.png", tests::snapshot_of(hall()), std::nullopt);
  const tests::PngPicture picture(folder / "map.png");
  int dark = 0;
  for (int x = 0; x < 100; ++x) {
    dark += picture.at(x, 24 * 8 + 22) == 0x141414 ? 1 : 0;
  }
  // 2.2 m are 352 pixels: 0.5 m is the longest that takes a third of them.
  EXPECT_EQ(dark, 80);
}

TEST(MapPng, OfNothingIsStillAPicture) {
  const tests::ScratchFolder folder;
  write_map_png(folder / "map.png", tests::snapshot_of(mapping::OccupancyGrid()), std::nullopt);
  const tests::PngPicture picture(folder / "map.png");
  EXPECT_GE(picture.width, 100);
  EXPECT_GE(picture.height, 40);
}

TEST(MapPng, KeepsALargeMapInBounds) {
  const tests::ScratchFolder folder;
  mapping::OccupancyGrid grid;
  grid.add({0, 0}, 300);
  grid.add({1500, 900}, 300);
  write_map_png(folder / "map.png", tests::snapshot_of(grid), std::nullopt);
  EXPECT_EQ(tests::PngPicture(folder / "map.png").width, 2 * 1505);
}

}  // namespace
}  // namespace echomap::exports
