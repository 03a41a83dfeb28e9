// SPDX-License-Identifier: MIT
#include "host/exports/map_view.hpp"

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::exports {
namespace {

/// 40 x 20 cells of 5 cm, 8 pixels each, without a border.
mapping::RasterMap drawn_hall() {
  return tests::map_from(tests::DrawnMap(20, std::string(40, '.')), 0.05, {-1.0, 2.0});
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

TEST(ScaleBar, IsRoundAndFits) {
  EXPECT_EQ(scale_bar_m(30.0), 10.0);
  EXPECT_EQ(scale_bar_m(4.9), 2.0);
  EXPECT_EQ(scale_bar_m(0.01), 0.1);
  EXPECT_EQ(length_text(0.5), "0.5 m");
  EXPECT_EQ(length_text(10.0), "10 m");
}

}  // namespace
}  // namespace echomap::exports
