// SPDX-License-Identifier: MIT
#include "host/evaluation/run_score.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"
#include "tests/support/told_snapshot.hpp"
#include "tests/support/truth_files.hpp"

namespace echomap::evaluation {
namespace {

using ::testing::HasSubstr;

/// The run that made that truth, believing to be `scale` times as fast and to start with a heading;
/// its map is all of the room.
pipeline::Snapshot run_of(double scale, double start_heading_rad = 0.0) {
  mapping::OccupancyGrid grid({.resolution_m = 0.1});
  for (int y = -5; y < 6; ++y) {
    for (int x = -5; x < 15; ++x) {
      grid.add({x, y}, -300);
    }
  }
  return tests::snapshot_of(grid,
                            {tests::pose_at(0.0, {0.0, 0.0, start_heading_rad}),
                             tests::pose_at(5.0, {0.5 * scale, 0.0, 0.0}),
                             tests::pose_at(10.0, {1.0 * scale, 0.0, 0.0})});
}

class RunScoreTest : public ::testing::Test {
 protected:
  RunScoreTest() { tests::write_truth_files(folder / "truth"); }

  RunScore score(double scale) {
    exports::write_run_directory(folder / "run", run_of(scale), {});
    return score_run(folder / "run", folder / "truth");
  }

  tests::ScratchFolder folder;
};

TEST_F(RunScoreTest, IsFullForAPerfectRun) {
  const RunScore perfect = score(1.0);
  EXPECT_EQ(perfect.start.map.free_iou, 1.0);
  EXPECT_NEAR(perfect.trajectory.ate_rmse_m, 0.0, 1e-6);
}

TEST_F(RunScoreTest, SeesThatTheRobotBelievesToBeFaster) {
  const RunScore wrong = score(1.1);
  EXPECT_NEAR(wrong.trajectory.final_error_m, 0.1, 1e-6);
}

TEST_F(RunScoreTest, FitsWhatTheStartPoseHasTurned) {
  // The same room driven by a robot that at first believed to look 0.1 rad to the side.
  exports::write_run_directory(folder / "run", run_of(1.0, 0.1), {});
  const RunScore score = score_run(folder / "run", folder / "truth");
  EXPECT_NEAR(score.fit_turn_rad, 0.1, 1e-6);
  EXPECT_EQ(score.fitted.map.free_iou, 1.0);
  EXPECT_LT(score.start.map.free_iou, 0.98);
}

TEST_F(RunScoreTest, NamesWhatIsMissing) {
  const auto complaint = tests::thrown_text<files::FileError>(
      [&] { score_run(folder / "nothing", folder / "truth"); });
  EXPECT_THAT(complaint, HasSubstr("map.yaml"));
}

TEST_F(RunScoreTest, NeedsAPoseToPlaceTheMapBy) {
  files::write_text_file(folder / "truth/truth.tum", "# nothing yet\n");
  const auto complaint = tests::thrown_text<files::FileError>([&] { score(1.0); });
  EXPECT_THAT(complaint, HasSubstr("truth.tum"));
}

}  // namespace
}  // namespace echomap::evaluation
