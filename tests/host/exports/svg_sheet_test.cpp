// SPDX-License-Identifier: MIT
#include "host/exports/svg_sheet.hpp"

#include <numbers>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::exports {
namespace {

using ::testing::HasSubstr;

SvgSheet sheet_of(double width_m, double height_m, double turn_rad = 0.0) {
  return {{turn_rad, {-1.0, 0.5}, {width_m, height_m}}, "hall", {{kFloorColour, "floor"}}};
}

TEST(SvgSheet, HasTheLargestRoundScaleThatFitsOnAPage) {
  EXPECT_EQ(sheet_of(0.4, 0.3).scale(), 5.0);
  EXPECT_EQ(sheet_of(3.5, 3.0).scale(), 20.0);
  EXPECT_EQ(sheet_of(3.7, 3.0).scale(), 50.0) << "3.7 m are 185 mm at 1 : 20";
  EXPECT_EQ(sheet_of(10.0, 12.0).scale(), 100.0);
  EXPECT_EQ(sheet_of(150.0, 10.0).scale(), 1000.0);
  EXPECT_NEAR(sheet_of(3.5, 3.0).metres(0.5), 0.01, 1e-12);
}

TEST(SvgSheet, SaysItsScaleInTheTitle) {
  EXPECT_THAT(sheet_of(3.5, 3.0).header(), HasSubstr(">hall, 1 : 20</text>"));
}

TEST(SvgSheet, PutsTheMapsLowerLeftCornerOnThePaper) {
  // 50 mm a metre: x = -1 m is at the left margin, y = 0.5 m at the map's lower end.
  const std::string header = sheet_of(3.5, 3.0).header();
  EXPECT_THAT(header, HasSubstr("translate(56 189) scale(50,-50)\""));
  EXPECT_THAT(header, HasSubstr("<rect x=\"6\" y=\"14\" width=\"175\" height=\"150\""));
}

TEST(SvgSheet, TurnsTheMapAsItsFrameSays) {
  EXPECT_THAT(sheet_of(3.5, 3.0, 0.5).header(), HasSubstr("rotate(-28.6479)"));
}

TEST(SvgSheet, ShowsNothingOfTheMapOnTitleAndLegend) {
  EXPECT_THAT(sheet_of(3.5, 3.0).header(), HasSubstr("<g clip-path=\"url(#map)\">"));
}

TEST(SvgSheet, HasRoomForALongTitleAndTheLegend) {
  const std::string title(60, 'x');
  const SvgSheet sheet(
      {0.0, {0, 0}, {0.4, 0.3}}, title, {{kFloorColour, "floor"}, {kWallColour, "occupied"}});
  std::smatch match;
  const std::string header = sheet.header();
  ASSERT_TRUE(std::regex_search(header, match, std::regex("width=\"([0-9.]+)mm")));
  EXPECT_GT(std::stod(match[1]), 60 * 2.0);
  EXPECT_THAT(sheet.footer(), HasSubstr(">occupied</text>"));
  EXPECT_THAT(sheet.footer(), HasSubstr(">0.1 m, grid 0.5 m</text>"));
}

TEST(SvgSheet, HasAGridAlongItsSidesThroughTheOriginOfTheMap) {
  // x from -1 to 2.5 m, y from 0.5 to 3.5 m.
  EXPECT_THAT(sheet_of(3.5, 3.0).grid(),
              HasSubstr("d=\"M-1 0.5L-1 3.5M0 0.5L0 3.5M1 0.5L1 3.5M2 0.5L2 3.5"
                        "M-1 1L2.5 1M-1 2L2.5 2M-1 3L2.5 3\""));
}

TEST(SvgSheet, TurnsTheGridWithThePaperAndNotWithTheMap) {
  // A quarter turn: the paper's x axis is the map's y axis.
  EXPECT_THAT(sheet_of(3.5, 3.0, std::numbers::pi / 2.0).grid(),
              HasSubstr("d=\"M-0.5 -1L-3.5 -1M-0.5 0L-3.5 0"));
}

}  // namespace
}  // namespace echomap::exports
