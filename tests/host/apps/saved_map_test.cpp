// SPDX-License-Identifier: MIT
#include "host/apps/saved_map.hpp"

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/session/pipeline_setup.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::apps {
namespace {

TEST(SavedMap, HoldsTheProfileOfItsRobotAndSaysWhoDrewTheOutline) {
  const tests::ScratchFolder out;
  const session::RobotProfile profile = session::load_robot_profile("uno_2wd");
  const auto pipeline = session::pipeline_for(profile, session::kNoSlam);
  exports::RunSummary summary;
  exports::RunDrawing drawing;
  drawing.outline_m = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}};
  save_map(pipeline, profile, out.path(), summary, drawing);
  EXPECT_TRUE(summary.outline_by_strategy);
  EXPECT_TRUE(exists(out / "map.pgm"));
  const session::RobotProfile again = session::load_robot_profile((out / kProfileName).string());
  EXPECT_EQ(again.name, profile.name);
  EXPECT_EQ(again.toml, profile.toml);
  save_map(pipeline, profile, out.path(), summary);
  EXPECT_FALSE(summary.outline_by_strategy);
}

TEST(SavedMap, HasAPoseGraphWhereThereIsSlam) {
  const tests::ScratchFolder out;
  const session::RobotProfile profile = session::load_robot_profile("uno_2wd");
  exports::RunSummary summary;
  save_map(session::pipeline_for(profile, "multiscan"), profile, out.path(), summary);
  EXPECT_TRUE(exists(out / "pose_graph.g2o"));
  save_map(session::pipeline_for(profile, session::kNoSlam), profile, out.path(), summary);
  EXPECT_FALSE(exists(out / "pose_graph.g2o")) << "that of the run before";
}

TEST(SavedMap, MovesAsideWhatAnEarlierRunHasLeft) {
  const tests::ScratchFolder out;
  files::write_text_file(out / kRecordName, "old");
  std::filesystem::create_directories(previous_map_of(out.path(), 1));
  move_earlier_run_aside(out.path());
  EXPECT_EQ(files::read_text_file(out / kPreviousRecordName), "old");
  EXPECT_FALSE(exists(out / kRecordName));
  EXPECT_TRUE(exists(out / "previous_1.before"));
  EXPECT_FALSE(exists(previous_map_of(out.path(), 1)));
}

TEST(SavedMap, MovesAsideThePreviousMapsOfBothNames) {
  const tests::ScratchFolder out;
  for (const char* name : {"previous_1", "former_1", "former_2"}) {
    std::filesystem::create_directories(out / name);
  }
  move_earlier_run_aside(out.path());
  EXPECT_FALSE(exists(stored_previous_map(out.path(), 1)));
  EXPECT_FALSE(exists(stored_previous_map(out.path(), 2)));
  for (const char* name : {"previous_1.before", "former_1.before", "former_2.before"}) {
    EXPECT_TRUE(exists(out / name)) << name;
  }
}

TEST(SavedMap, ReadsAPreviousMapOfAnOlderVersionAndWritesNoneOfThatName) {
  const tests::ScratchFolder run;
  std::filesystem::create_directories(run / "former_1");
  EXPECT_EQ(stored_previous_map(run.path(), 1), run / "former_1");
  EXPECT_EQ(previous_map_of(run.path(), 1), run / "previous_1");
  std::filesystem::create_directories(run / "previous_1");
  EXPECT_EQ(stored_previous_map(run.path(), 1), run / "previous_1");
  EXPECT_FALSE(exists(stored_previous_map(run.path(), 2)));
}

TEST(SavedMap, RemovesWhatTheNextRunMayNotWrite) {
  const tests::ScratchFolder out;
  for (const char* name : {"confidence_grid.csv", "landmarks.csv", "pose_graph.g2o", "notes.txt"}) {
    files::write_text_file(out / name, "old");
  }
  move_earlier_run_aside(out.path());
  EXPECT_FALSE(exists(out / "confidence_grid.csv"));
  EXPECT_FALSE(exists(out / "landmarks.csv"));
  EXPECT_FALSE(exists(out / "pose_graph.g2o"));
  EXPECT_TRUE(exists(out / "notes.txt")) << "not echomap's";
}

}  // namespace
}  // namespace echomap::apps
