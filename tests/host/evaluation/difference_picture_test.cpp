// SPDX-License-Identifier: MIT
#include "host/evaluation/difference_picture.hpp"

#include <gtest/gtest.h>

#include "host/exports/png_text.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/png_picture.hpp"
#include "tests/support/png_texts.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::evaluation {
namespace {

constexpr int kAppeared = 0xD55E00;
constexpr int kWallAfter = 0x009E73;

TEST(DifferencePicture, ShowsRegionsAndTheWallsOfBothMaps) {
  const tests::ScratchFolder folder;
  const auto before = tests::map_from(tests::DrawnMap(20, std::string(40, '.')), 0.05);
  auto after = tests::map_from({"#"}, 0.05);
  MapDifference difference;
  difference.alignment.T_a_b = {0.5, 0.75, 0.0};
  ChangedRegion region;
  region.cells_m = {{1.025, 0.525}, {1.075, 0.525}};
  region.center_m = {1.05, 0.525};
  region.size_m = {0.1, 0.05};
  difference.regions = {region};
  write_difference_picture(folder / "a.png", before, after, difference);
  const tests::PngPicture picture(folder / "a.png");
  // 8 pixels a cell of 5 cm, y downwards from 1 m; the legend is narrower than the map.
  const auto pixel = [&](double x_m, double y_m) {
    return picture.at(static_cast<int>(x_m * 160.0), static_cast<int>((1.0 - y_m) * 160.0));
  };
  EXPECT_EQ(pixel(1.025, 0.525), kAppeared);
  EXPECT_EQ(pixel(1.075, 0.525), kAppeared);
  EXPECT_EQ(pixel(1.05, 0.45), kAppeared) << "the frame";
  EXPECT_EQ(pixel(0.525, 0.775), kWallAfter);
  EXPECT_EQ(pixel(1.53, 0.23), 0xFFFFFF);
  EXPECT_EQ(tests::read_png_texts(folder / "a.png").size(), 3U);
}

TEST(DifferencePicture, HoldsBothMaps) {
  const tests::ScratchFolder folder;
  const auto before = tests::map_from(tests::DrawnMap(20, std::string(40, '.')), 0.05);
  MapDifference difference;
  difference.alignment.T_a_b = {-1.0, 0.0, 0.0};
  write_difference_picture(folder / "a.png", before, before, difference);
  EXPECT_GE(tests::PngPicture(folder / "a.png").width, 60 * 8);
}

}  // namespace
}  // namespace echomap::evaluation
