// SPDX-License-Identifier: MIT
#include "host/exports/svg_elements.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::exports {
namespace {

using ::testing::HasSubstr;

TEST(SvgNumber, HasNoDecimalsThatSayNothing) {
  EXPECT_EQ(svg_number(2.0), "2");
  EXPECT_EQ(svg_number(-0.25), "-0.25");
  EXPECT_EQ(svg_number(0.12345), "0.1235");
  EXPECT_EQ(svg_number(-0.00001), "0");
  EXPECT_EQ(svg_number(100.0), "100");
}

TEST(SvgEscaped, KeepsTextFromBeingMarkup) {
  EXPECT_EQ(svg_escaped("a < b & c"), "a &lt; b &amp; c");
  EXPECT_THAT(svg_text({1, 2}, 3, "<b>"), HasSubstr(">&lt;b></text>"));
}

TEST(SvgPaths, AreOpenOrClosed) {
  EXPECT_EQ(svg_polyline({{0, 0}, {1, 0.5}}), "M0 0L1 0.5");
  EXPECT_EQ(svg_polygon({{0, 0}, {1, 0}, {1, 1}}), "M0 0L1 0L1 1z");
  EXPECT_EQ(svg_polygon({}), "");
  EXPECT_EQ(svg_circle({1, 2}, 0.5), "M0.5 2a0.5 0.5 0 1 0 1 0a0.5 0.5 0 1 0 -1 0z");
}

TEST(SvgElements, HaveTheirColours) {
  EXPECT_THAT(svg_filled("floor", {255, 0, 16}, "M0 0z"), HasSubstr("fill=\"#ff0010\""));
  EXPECT_THAT(svg_stroked("trail", {1, 2, 3}, 0.5, "M0 0"), HasSubstr("stroke-width=\"0.5\""));
  EXPECT_THAT(svg_rectangle({1, 2}, {3, 4}, {0, 0, 0}),
              HasSubstr("x=\"1\" y=\"2\" width=\"3\" height=\"4\""));
}

}  // namespace
}  // namespace echomap::exports
