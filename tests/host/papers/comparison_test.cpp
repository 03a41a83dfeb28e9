// SPDX-License-Identifier: MIT
#include "host/papers/comparison.hpp"

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

ExplorationRun run_with(const nlohmann::json& summary) { return {{}, summary}; }

TEST(Comparison, HasTheMeanOfBothMethodsInTheUnit) {
  const Comparison runs{{run_with({{"error_m", 0.02}}), run_with({{"error_m", 0.04}})},
                        {run_with({{"error_m", 0.01}}), run_with({{"other", 1.0}})}};
  const auto finding = compared(runs, {"error", "figure 1", "none", "/error_m", 100.0, "cm", 1});
  EXPECT_DOUBLE_EQ(finding.as_told.value().value, 3.0);
  EXPECT_EQ(finding.as_told.value().runs, 2U);
  EXPECT_DOUBLE_EQ(finding.ours.value().value, 1.0);
  EXPECT_EQ(finding.ours.value().runs, 1U);
  EXPECT_EQ(finding.unit, "cm");
}

TEST(Comparison, AMethodWithoutTheNumberHasNone) {
  const Comparison runs{{run_with({{"error_m", 0.02}})}, {run_with({{"other", 1.0}})}};
  EXPECT_FALSE(compared(runs, {"error", "-", "-", "/error_m"}).ours);
}

TEST(Comparison, CountsRunsOfWhichTwoNumbersAreEqual) {
  const std::vector<ExplorationRun> runs{run_with({{"found", 6}, {"true", 6}}),
                                         run_with({{"found", 5}, {"true", 6}}),
                                         run_with({{"found", nullptr}})};
  const auto share = percent_equal(runs, "/found", "/true");
  EXPECT_NEAR(share.value, 100.0 / 3.0, 1e-9);
  EXPECT_EQ(share.runs, 3U);
}

TEST(Comparison, PointsOfARunAreMovedToTheWorld) {
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "points.csv", "x_m,y_m,pose_index\n1.5,-0.25,0\n0,2e-1,3\n");
  const auto points_m = points_of({folder.path(), {}}, "points.csv", {1.0, 2.0, 0.0});
  ASSERT_EQ(points_m.size(), 2U);
  EXPECT_EQ(points_m[0], Eigen::Vector2d(2.5, 1.75));
  EXPECT_EQ(points_m[1], Eigen::Vector2d(1.0, 2.2));
  files::write_text_file(folder / "points.csv", "x_m,y_m\n1.5\n");
  EXPECT_THROW(points_of({folder.path(), {}}, "points.csv", {}), files::FileError);
}

TEST(Comparison, APictureIsThatOfTheRun) {
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "map.png", "\x89PNG");
  const auto picture = map_picture({folder.path(), {}}, "title", "figure 8", "caption");
  EXPECT_EQ(picture.png.size(), 4U);
  EXPECT_EQ(picture.where, "figure 8");
}

}  // namespace
}  // namespace echomap::papers
