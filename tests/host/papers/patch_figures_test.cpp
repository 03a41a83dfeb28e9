// SPDX-License-Identifier: MIT
#include "host/papers/patch_figures.hpp"

#include <gtest/gtest.h>

namespace echomap::papers {
namespace {

/// A drive that has marked every cell within 5 cm of a side, and nothing else.
PatchDrive marked_sides(const Playground& playground) {
  PatchDrive drive{mapping::CellField({{0, 0}, {55, 43}}, 0.05), {{0.35, 1.0}}, 1, 0.1};
  for (std::size_t i = 0; i < drive.confidence.size(); ++i) {
    const Eigen::Vector2d center_m = drive.confidence.center_m(drive.confidence.cell(i));
    drive.confidence[i] = playground.for_bumper.clearance_m(center_m) < 0.05 ? 2.0F : 0.0F;
  }
  return drive;
}

TEST(PatchFigures, OfAGridThatHasAllSidesAndNothingElseAreGood) {
  const Playground playground = make_playground();
  const PatchFigures figures = patch_figures(playground, marked_sides(playground));
  EXPECT_GT(figures.walls_found, 0.99);
  EXPECT_GT(figures.boxes_found, 0.99);
  EXPECT_LT(figures.occupied_rms_m, 0.05);
  EXPECT_NEAR(figures.echo_rms_m, 0.0, 1e-9);
  EXPECT_EQ(figures.open_floor_wrong, 0.0);
  EXPECT_EQ(figures.final_error_m, 0.1);
}

TEST(PatchFigures, OfAnEmptyGridFindNothing) {
  const Playground playground = make_playground();
  PatchDrive drive = marked_sides(playground);
  drive.confidence.clear();
  drive.confidence[drive.confidence.index({20, 20})] = 2.0F;
  const PatchFigures figures = patch_figures(playground, drive);
  EXPECT_EQ(figures.walls_found, 0.0);
  EXPECT_EQ(figures.block, 0.0);
}

}  // namespace
}  // namespace echomap::papers
