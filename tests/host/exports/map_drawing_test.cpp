// SPDX-License-Identifier: MIT
#include "host/exports/map_drawing.hpp"

#include <memory>

#include <gtest/gtest.h>

#include "host/mapping/raster_map.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exports {
namespace {

/// 2 x 1 m of floor from the origin on, with a wall in the row above and one fitted to it.
pipeline::Snapshot room_with_a_fitted_wall() {
  mapping::OccupancyGrid grid;
  for (int y = 0; y < 21; ++y) {
    for (int x = 0; x < 40; ++x) {
      grid.add({x, y}, y == 20 ? 300 : -300);
    }
  }
  pipeline::Snapshot snapshot =
      tests::snapshot_of(std::move(grid), {tests::pose_at(0.0, {0.5, 0.5, 0.0})});
  mapping::SonarFeatures features;
  features.walls = {{{0.0, 1.025}, {2.0, 1.025}}};
  snapshot.features = std::make_shared<const mapping::SonarFeatures>(features);
  return snapshot;
}

Colour colour_at(const Picture& picture, const MapView& view, const Eigen::Vector2d& point_m) {
  const Eigen::Vector2d place = view.place(point_m);
  return picture.at(static_cast<int>(place.x()), static_cast<int>(place.y()));
}

TEST(MapDrawing, DrawsFittedWallsOverTheCells) {
  const auto snapshot = room_with_a_fitted_wall();
  const MapView view(mapping::rasterize(*snapshot.grid));
  const Picture picture = draw_map(view, snapshot, std::nullopt, {});
  EXPECT_EQ(colour_at(picture, view, {1.53, 1.025}), kFittedColour);
  EXPECT_EQ(colour_at(picture, view, {1.53, 1.045}), kWallColour);
  const Picture without = draw_map(view, snapshot, std::nullopt, {.shows_features = false});
  EXPECT_EQ(colour_at(without, view, {1.53, 1.025}), kWallColour);
}

TEST(MapDrawing, DrawsTheOutlineBelowTheFittedWalls) {
  const auto snapshot = room_with_a_fitted_wall();
  const MapView view(mapping::rasterize(*snapshot.grid));
  const mapping::PolygonMap outline({{0.0, 0.1}, {1.9, 0.1}, {1.9, 1.025}, {0.0, 1.025}});
  const Picture picture = draw_map(view, snapshot, outline, {});
  EXPECT_EQ(colour_at(picture, view, {1.53, 0.1}), kOutlineColour);
  EXPECT_EQ(colour_at(picture, view, {1.53, 1.025}), kFittedColour);
}

TEST(MapDrawing, DrawsLandmarksAsLinesAndDots) {
  const auto snapshot = room_with_a_fitted_wall();
  const MapView view(mapping::rasterize(*snapshot.grid));
  MapStyle style;
  style.landmarks = {{{1.5, 0.5}}, {{{0.2, 0.22}, {1.8, 0.22}}}};
  const Picture picture = draw_map(view, snapshot, std::nullopt, style);
  EXPECT_EQ(colour_at(picture, view, {1.5, 0.5}), kLandmarkColour);
  EXPECT_EQ(colour_at(picture, view, {1.03, 0.22}), kLandmarkColour);
  EXPECT_EQ(colour_at(picture, view, {1.93, 0.22}), kFloorColour);
}

TEST(MapDrawing, DrawsTheRobotInItsSize) {
  const auto snapshot = room_with_a_fitted_wall();
  const MapView view(mapping::rasterize(*snapshot.grid));
  const Picture picture = draw_map(view, snapshot, std::nullopt, {.robot_radius_m = 0.2});
  EXPECT_EQ(colour_at(picture, view, {0.5, 0.68}), kRobotColour);
  EXPECT_EQ(colour_at(picture, view, {0.53, 0.73}), kFloorColour);
  EXPECT_EQ(colour_at(picture, view, {0.6, 0.5}), kInkColour) << "its nose";
}

TEST(MapDrawing, LeavesTheTitleFreeOfWhatLiesBeyondTheMap) {
  auto snapshot = room_with_a_fitted_wall();
  const MapView view(mapping::rasterize(*snapshot.grid), {.title = "hall"});
  const Picture without = draw_map(view, snapshot, std::nullopt, {.shows_features = false});
  mapping::SonarFeatures features;
  features.walls = {{{0.1, -5.0}, {0.1, 5.0}}};
  snapshot.features = std::make_shared<const mapping::SonarFeatures>(features);
  const Picture picture = draw_map(view, snapshot, std::nullopt, {});
  EXPECT_EQ(colour_at(picture, view, {0.1, 0.9}), kFittedColour);
  const int x = static_cast<int>(view.place({0.1, 0.9}).x());
  for (const int y : {0, 10, 29, picture.height() - 40, picture.height() - 1}) {
    EXPECT_EQ(picture.at(x, y), without.at(x, y)) << y;
  }
}

TEST(MapDrawing, ShowsAGivenFrameWhateverTheMapHolds) {
  const auto snapshot = room_with_a_fitted_wall();
  const PictureFrame frame{.low_m = {-1.0, -1.0}, .size_m = {4.0, 3.0}};
  const MapView view(mapping::rasterize(*snapshot.grid), {.frame = frame, .max_map_width_px = 400});
  const Picture picture = draw_map(view, snapshot, std::nullopt, {});
  EXPECT_EQ(picture.width(), 400);
  EXPECT_EQ(view.place({-1.0, 2.0}), Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(colour_at(picture, view, {0.275, 0.175}), kFloorColour);
}

}  // namespace
}  // namespace echomap::exports
