// SPDX-License-Identifier: MIT
#include "host/exports/map_gif.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/exports/map_png.hpp"
#include "host/exports/map_view.hpp"
#include "host/files/atomic_file.hpp"
#include "host/mapping/raster_map.hpp"
#include "tests/support/gif_pictures.hpp"
#include "tests/support/png_picture.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exports {
namespace {

/// Floor that many columns wide and 20 rows high with a wall above; the robot is at its right end.
pipeline::Snapshot floor_of(int columns) {
  mapping::OccupancyGrid grid;
  for (int y = 0; y < 21; ++y) {
    for (int x = 0; x < columns; ++x) {
      grid.add({x, y}, y == 20 ? 300 : -300);
    }
  }
  mapping::PointCloudMap points;
  points.add({geometry::Pose2(), geometry::Pose2(0.0, 0.5, 0.0), 0.05 * columns});
  return tests::snapshot_of(std::move(grid),
                            {tests::pose_at(0.0, {0.3, 0.5, 0.0}),
                             tests::pose_at(0.1 * columns, {0.05 * columns - 0.2, 0.5, 0.0})},
                            std::move(points));
}

std::optional<mapping::PolygonMap> outline_of(const pipeline::Snapshot& snapshot) {
  return mapping::polygon_from_raster(mapping::rasterize(*snapshot.grid));
}

/// A map that grows from 10 columns on, by one a frame.
void add_frames(MapAnimation& animation, int frames) {
  for (int i = 0; i < frames; ++i) {
    const pipeline::Snapshot snapshot = floor_of(10 + i);
    animation.add(snapshot, outline_of(snapshot), std::to_string(i) + " stops");
  }
}

tests::GifPictures saved(const MapAnimation& animation, const tests::ScratchFolder& folder) {
  animation.save(folder / "map.gif");
  return tests::GifPictures(folder / "map.gif");
}

TEST(MapGif, ShowsEveryFrameAndTheLastOneLonger) {
  const tests::ScratchFolder folder;
  MapAnimation animation;
  add_frames(animation, 5);
  const tests::GifPictures gif = saved(animation, folder);
  EXPECT_EQ(gif.repetitions, 0) << "for ever";
  ASSERT_EQ(gif.images.size(), 5U);
  EXPECT_EQ(gif.images[0].control.DelayTime, 40);
  EXPECT_EQ(gif.images[4].control.DelayTime, 300);
}

TEST(MapGif, EndsWithThePixelsOfTheMapsPicture) {
  const tests::ScratchFolder folder;
  MapAnimation animation({.title = "hall"});
  add_frames(animation, 31);
  const tests::GifPictures gif = saved(animation, folder);
  const pipeline::Snapshot last = floor_of(40);
  write_map_png(folder / "map.png", last, outline_of(last), {.title = "hall, 30 stops"});
  const tests::PngPicture png(folder / "map.png");
  ASSERT_EQ(gif.width, png.width);
  ASSERT_EQ(gif.height, png.height);
  EXPECT_EQ(gif.images.back().shown, png.pixels);
}

TEST(MapGif, KeepsTheRoomWhereItIs) {
  const tests::ScratchFolder folder;
  MapAnimation animation;
  add_frames(animation, 31);
  const tests::GifPictures gif = saved(animation, folder);
  // The wall of the first frame, at the left of the last one's, in the middle of a cell.
  constexpr int kWall = 0x282828;
  int row = 0;
  while (row < gif.height && gif.at(30, 8 + 8 + 4, row) != kWall) {
    ++row;
  }
  EXPECT_EQ(gif.at(0, 8 + 8 + 4, row), kWall);
  EXPECT_EQ(gif.at(30, 8 + 30 * 8 + 4, row), kWall);
  EXPECT_NE(gif.at(0, 8 + 30 * 8 + 4, row), kWall);
}

TEST(MapGif, DrawsTheCaptionOfEachFrame) {
  const tests::ScratchFolder folder;
  MapAnimation animation;
  const pipeline::Snapshot snapshot = floor_of(40);
  animation.add(snapshot, std::nullopt, "0");
  animation.add(snapshot, std::nullopt, "12");
  const tests::GifPictures gif = saved(animation, folder);
  const GifImageDesc change = gif.images[1].place;
  EXPECT_GE(change.Top, 8) << "nothing but the title line has changed";
  EXPECT_LE(change.Top + change.Height, 8 + 14);
}

TEST(MapGif, ThinsOutEvenlyAndKeepsTheLastFrame) {
  const tests::ScratchFolder folder;
  MapAnimation animation({.max_frames = 6});
  add_frames(animation, 31);
  const tests::GifPictures gif = saved(animation, folder);
  ASSERT_EQ(gif.images.size(), 6U);
  MapAnimation all({.max_frames = 31});
  add_frames(all, 31);
  const tests::GifPictures whole = saved(all, folder);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto same = std::find_if(whole.images.begin(), whole.images.end(), [&](const auto& one) {
      return one.shown == gif.images[i].shown;
    });
    ASSERT_NE(same, whole.images.end()) << i;
    EXPECT_NEAR(static_cast<double>(same - whole.images.begin()), 6.0 * static_cast<double>(i), 4.0)
        << i;
  }
  EXPECT_EQ(gif.images.back().shown, whole.images.back().shown);
}

TEST(MapGif, FitsIntoItsWidthAndSoDoesALongTitle) {
  const tests::ScratchFolder folder;
  MapAnimation animation({.title = std::string(90, 'x'), .max_width_px = 250});
  add_frames(animation, 90);
  const tests::GifPictures gif = saved(animation, folder);
  EXPECT_LE(gif.width, 250);
  EXPECT_GE(gif.width, 200);
}

TEST(MapGif, WritesTheSameBytesAgain) {
  const tests::ScratchFolder folder;
  MapAnimation animation({.turn_rad = 0.3});
  add_frames(animation, 4);
  animation.save(folder / "a.gif");
  animation.save(folder / "b.gif");
  EXPECT_EQ(files::read_text_file(folder / "a.gif"), files::read_text_file(folder / "b.gif"));
}

TEST(MapGif, OfNothingIsNoFile) {
  const tests::ScratchFolder folder;
  EXPECT_THROW(MapAnimation().save(folder / "map.gif"), files::FileError);
}

TEST(MapGif, OfAMapWithoutACellIsStillAPicture) {
  const tests::ScratchFolder folder;
  MapAnimation animation;
  animation.add(tests::snapshot_of(mapping::OccupancyGrid()), std::nullopt, "");
  EXPECT_EQ(saved(animation, folder).images.size(), 1U);
}

TEST(MapGif, RefusesParametersOutOfRange) {
  EXPECT_THROW(MapAnimation({.frame_ms = 5}), std::invalid_argument);
  EXPECT_THROW(MapAnimation({.last_frame_ms = -1}), std::invalid_argument);
  EXPECT_THROW(MapAnimation({.max_frames = 1}), std::invalid_argument);
  EXPECT_THROW(MapAnimation({.max_width_px = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exports
