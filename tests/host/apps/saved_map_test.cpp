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
  files::write_text_file(out / "session.mcap", "old");
  files::write_text_file(out / "session_1.mcap", "its second part");
  files::write_text_file(out / "session.before.mcap", "older");
  files::write_text_file(out / "session.before_1.mcap", "older");
  files::write_text_file(out / "session.before_2.mcap", "older");
  std::filesystem::create_directories(previous_map_of(out.path(), 1));
  move_earlier_run_aside(out.path());
  EXPECT_EQ(files::read_text_file(out / kPreviousRecordingName), "old");
  EXPECT_EQ(files::read_text_file(out / "session.before_1.mcap"), "its second part");
  EXPECT_FALSE(exists(out / "session.mcap"));
  EXPECT_FALSE(exists(out / "session_1.mcap"));
  EXPECT_FALSE(exists(out / "session.before_2.mcap")) << "it would be read as its third part";
  EXPECT_TRUE(exists(out / "previous_1.before"));
  EXPECT_FALSE(exists(previous_map_of(out.path(), 1)));
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
