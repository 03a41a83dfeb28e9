// SPDX-License-Identifier: MIT
#include "host/papers/error_plot.hpp"

#include <gtest/gtest.h>

#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(ErrorPlot, IsWrittenAndHasItsCurves) {
  const tests::ScratchFolder folder;
  const ErrorCurve in_x{"x", {0.0, 0.01, -0.01}, {0.03, 0.03, 0.03}};
  ErrorCurve in_y = in_x;
  const auto plot = draw_errors(folder / "sub/plot.png", {in_x, in_y}, 0.05);
  EXPECT_EQ(plot.size(), file_size(folder / "sub/plot.png"));
  in_y.error_m[1] = 0.02;
  EXPECT_NE(draw_errors(folder / "plot.png", {in_x, in_y}, 0.05), plot);
}

TEST(ErrorPlot, WhatIsBeyondTheLimitIsAtTheEdge) {
  const tests::ScratchFolder folder;
  const auto at_the_edge = draw_errors(folder / "a.png", {{"x", {0.0, 0.05}, {0.01, 0.01}}}, 0.05);
  const auto beyond = draw_errors(folder / "b.png", {{"x", {0.0, 9.0}, {0.01, 0.01}}}, 0.05);
  EXPECT_EQ(at_the_edge, beyond);
}

}  // namespace
}  // namespace echomap::papers
