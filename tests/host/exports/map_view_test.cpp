// SPDX-License-Identifier: MIT
#include "host/exports/map_view.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::exports {
namespace {

/// 40 x 20 cells of 5 cm, 8 pixels each, without a border.
mapping::RasterMap drawn_hall() {
  return tests::map_from(tests::DrawnMap(20, std::string(40, '.')), 0.05, {-1.0, 2.0});
}

/// From column `x` on, below the map of drawn_hall().
int ink_in_footer(const Picture& picture, int x) {
  int ink = 0;
  for (int y = 20 * 8; y < picture.height(); ++y) {
    for (int column = x; column < picture.width(); ++column) {
      ink += picture.at(column, y) == kInkColour ? 1 : 0;
    }
  }
  return ink;
}

TEST(MapView, PlacesPointsWhereItPaintsTheirCells) {
  const auto map = drawn_hall();
  const MapView view(map);
  Picture picture = view.draw();
  view.fill_cell(picture, {7, 3}, kOrange);
  const Eigen::Vector2d place = view.place(map.center_m({7, 3}));
  EXPECT_EQ(picture.at(static_cast<int>(place.x()), static_cast<int>(place.y())), kOrange);
  const Eigen::Vector2d beside = view.place(map.center_m({8, 3}));
  EXPECT_EQ(picture.at(static_cast<int>(beside.x()), static_cast<int>(beside.y())), kFloorColour);
}

TEST(MapView, ShowsEachEntryOfTheLegend) {
  const MapView view(drawn_hall(), {.legend = {{kOrange, "appeared"}, {kBlue, "vanished"}}});
  const Picture picture = view.draw();
  EXPECT_EQ(picture.height(), 20 * 8 + 44 + 24);
  EXPECT_EQ(picture.at(20, 20 * 8 + 44 + 7), kOrange);
  EXPECT_EQ(picture.at(14 + 42 + 14 + Picture::text_width("appeared", 2) + 6, 20 * 8 + 44 + 7),
            kBlue);
}

TEST(MapView, IsWideEnoughForItsLegend) {
  const std::string text(60, 'a');
  const MapView view(tests::map_from({"."}), {.legend = {{kOrange, text}}});
  EXPECT_GT(view.draw().width(), Picture::text_width(text, 2));
}

TEST(MapView, SaysWhereItLies) {
  const auto texts = MapView(drawn_hall()).texts();
  ASSERT_EQ(texts.size(), 3U);
  EXPECT_EQ(texts[1], (PngText{"resolution", "0.00625"}));
  // 44 pixels of footer are below the map.
  EXPECT_EQ(texts[2], (PngText{"origin", "[-1, 1.725, 0]"}));
}

TEST(MapView, HasAGridThroughTheOriginOfTheMapBelowItsWalls) {
  // From (-1, 2): lines of 0.5 m on the first column of pixels of cells 0, 10, .. and in the lowest
  // row of pixels of cells 0 and 10.
  auto map = drawn_hall();
  map.set({20, 5}, mapping::CellState::kOccupied);
  const Picture picture = MapView(map).draw();
  EXPECT_EQ(picture.at(80, 100), kGridColour);
  EXPECT_EQ(picture.at(81, 100), kFloorColour);
  EXPECT_EQ(picture.at(79, 100), kFloorColour);
  EXPECT_EQ(picture.at(100, 79), kGridColour);
  EXPECT_EQ(picture.at(100, 80), kFloorColour);
  EXPECT_EQ(picture.at(160, 20 * 8 - 5 * 8 - 4), kWallColour);
  EXPECT_EQ(picture.at(160, 20 * 8 - 4 * 8 - 4), kGridColour);
}

TEST(MapView, HasItsGridOnUnknownGround) {
  const MapView view(tests::map_from(tests::DrawnMap(20, std::string(40, ' ')), 0.05));
  EXPECT_EQ(view.draw().at(80, 100), kGridColour);
}

TEST(MapView, HasNoGridWhereNoneIsWanted) {
  const Picture picture = MapView(drawn_hall(), {.shows_metre_grid = false}).draw();
  const Picture with_grid = MapView(drawn_hall()).draw();
  EXPECT_EQ(picture.at(80, 100), kFloorColour);
  // Behind the bar of 0.5 m and its length.
  const int x = 14 + 80 + 14 + Picture::text_width("0.5 m", 2);
  EXPECT_GT(ink_in_footer(with_grid, x), 0);
  EXPECT_EQ(ink_in_footer(picture, x), 0);
}

TEST(MapView, DrawsItsGridAlongThePicturesAxesWhenTurned) {
  const MapView view(drawn_hall(), {.turn_rad = 0.4, .points_m = {{0.0, 2.5}}});
  const Picture picture = view.draw();
  const Eigen::Vector2d place = view.place({0.0, 2.5});
  // The line x = 0 of the picture's axes: its x is that of the map's origin.
  const int x = static_cast<int>(std::lround(view.place({0.0, 0.0}).x()));
  const int middle = static_cast<int>(place.y());
  for (int y = middle - 5; y < middle + 5; ++y) {
    EXPECT_TRUE(picture.at(x, y) == kGridColour || picture.at(x - 1, y) == kGridColour) << y;
  }
}

TEST(GridSpacing, FitsTheSizeOfTheRoom) {
  EXPECT_EQ(grid_spacing_m({2.9, 1.0}), 0.5);
  EXPECT_EQ(grid_spacing_m({3.0, 1.0}), 1.0);
  EXPECT_EQ(grid_spacing_m({4.0, 30.0}), 1.0);
  EXPECT_EQ(grid_spacing_m({31.0, 4.0}), 5.0);
  EXPECT_EQ(scale_text(1.0, 0.5), "1 m, grid 0.5 m");
}

TEST(ScaleBar, IsRoundAndFits) {
  EXPECT_EQ(scale_bar_m(30.0), 10.0);
  EXPECT_EQ(scale_bar_m(4.9), 2.0);
  EXPECT_EQ(scale_bar_m(0.01), 0.1);
  EXPECT_EQ(length_text(0.5), "0.5 m");
  EXPECT_EQ(length_text(10.0), "10 m");
}

}  // namespace
}  // namespace echomap::exports
