// SPDX-License-Identifier: MIT
#include "host/papers/map_panels.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/paper_report/png_data.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

/// A path through a room whose walls beams have met often.
MapPanel room_panel() {
  MapPanel panel;
  for (int i = 0; i < 40; ++i) {
    for (int again = 0; again < 3; ++again) {
      panel.ends_m.emplace_back(0.1 * i, 0.0);
      panel.ends_m.emplace_back(0.1 * i, 3.0);
    }
  }
  panel.path = {{0.5, 1.0, 0.0}, {3.5, 1.0, 0.0}};
  return panel;
}

TEST(MapPanels, LieBesideEachOther) {
  const tests::ScratchFolder folder;
  const auto one = draw_panels(folder / "one.png", {room_panel()}, 0.05);
  const auto two = draw_panels(folder / "two.png", {room_panel(), room_panel()}, 0.05);
  EXPECT_TRUE(exists(folder / "two.png"));
  const auto size_of_one = paper_report::png_size(one);
  const auto size_of_two = paper_report::png_size(two);
  ASSERT_TRUE(size_of_one && size_of_two);
  EXPECT_GT(size_of_two->width_px * size_of_one->height_px,
            1.5 * size_of_one->width_px * size_of_two->height_px);
}

TEST(MapPanels, ShowPathLandmarksAndTrueWalls) {
  const tests::ScratchFolder folder;
  const auto draw = [&](const MapPanel& panel) {
    return draw_panels(folder / "a.png", {panel}, 0.05);
  };
  const auto plain = draw(room_panel());
  MapPanel walls = room_panel();
  walls.walls = {{{0.0, 0.0}, {3.9, 0.0}}};
  MapPanel points = room_panel();
  points.points_m = {{2.0, 2.0}};
  MapPanel truth = room_panel();
  truth.true_walls = {{{0.0, 2.0}, {3.9, 2.0}}};
  MapPanel still = room_panel();
  still.path.clear();
  for (const MapPanel& changed : {walls, points, truth, still}) {
    EXPECT_NE(draw(changed), plain);
  }
}

TEST(MapPanels, OfNothingAreRefused) {
  const tests::ScratchFolder folder;
  EXPECT_THROW(draw_panels(folder / "a.png", {MapPanel{}}, 0.05), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::papers
