// SPDX-License-Identifier: MIT
#include "host/apps/run_writer.hpp"

#include <gtest/gtest.h>

#include "host/apps/saved_map.hpp"
#include "host/files/atomic_file.hpp"
#include "host/recording/session_reader.hpp"
#include "host/session/pipeline_setup.hpp"
#include "host/strategies/strategy_setup.hpp"
#include "tests/host/session/session_on_a_cable.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::apps {
namespace {

/// Has made nothing of its own.
class Idler final : public exploration::Explorer {
 public:
  exploration::Motion next(const pipeline::Snapshot& /*snapshot*/,
                           exploration::MotionResult /*last*/) override {
    return exploration::Finished{};
  }
};

class RunWriterTest : public session::SessionOnACable {
 protected:
  pipeline::RobotAtlas& begin_maps() {
    robot.begin_maps(session::kNoSlam);
    robot.open({new_connection(), nullptr});
    return robot.atlas();
  }
  void stop() {
    atlas.on_odometry({stamp += std::chrono::milliseconds(20), {}});
    atlas.begin_scan();
    atlas.end_scan();
  }

  session::RobotContext robot{profile, session::Seed(1)};
  LiveRun live{LiveOptions(), robot, {}};
  pipeline::RobotAtlas& atlas = begin_maps();
  time::RobotTime stamp;
  Idler explorer;
  const tests::ScratchFolder out;
  const strategies::StrategyOptions strategy;
  const ExploreRun run{strategy, live, out.path(), ProgressDisplay::kNone};
  exports::RunSummary summary;
};

TEST_F(RunWriterTest, AMapThatWasSetAsideHasARunDirectoryOfItsOwn) {
  RunWriter writer(robot, explorer, run, summary);
  stop();
  writer.save();
  EXPECT_FALSE(exists(out / "previous_1"));
  stop();
  stop();
  atlas.begin_new_map(2);
  writer.save();
  EXPECT_EQ(summary.previous_maps, 1U);
  EXPECT_EQ(summary.stops, 1U);
  EXPECT_TRUE(exists(out / "previous_1/map.png"));
}

TEST_F(RunWriterTest, BeginsTheRecordingWithWhatTheRunIs) {
  summary.world = "attic";
  RunWriter writer(robot, explorer, run, summary);
  writer.begin();
  robot.recorder().finish();
  const recording::SessionReader recording(out / recording::kSessionFileName);
  EXPECT_EQ(recording.fact("session", "world"), "attic");
  EXPECT_EQ(recording.fact("session", "robot"), profile.name);
  EXPECT_EQ(recording.attachment("robot.toml"), profile.toml);
}

TEST_F(RunWriterTest, AMapThatCouldNotBeSavedIsSavedTheNextTime) {
  RunWriter writer(robot, explorer, run, summary);
  stop();
  writer.save_in_passing();
  files::write_text_file(out / "previous_1", "in the way");
  stop();
  stop();
  atlas.begin_new_map(2);
  writer.save_in_passing();
  EXPECT_EQ(files::read_text_file(out / "previous_1"), "in the way");
  std::filesystem::remove(out / "previous_1");
  writer.save();
  EXPECT_TRUE(exists(out / "previous_1/map.pgm"));
}

TEST_F(RunWriterTest, WhatAFormerRunHasLeftStaysBesideIt) {
  files::write_text_file(out / recording::kSessionFileName, "old");
  std::filesystem::create_directories(out / "previous_1");
  files::write_text_file(out / "previous_1/map.png", "old");
  RunWriter writer(robot, explorer, run, summary);
  writer.begin();
  writer.save();
  EXPECT_EQ(files::read_text_file(out / kPreviousRecordingName), "old");
  EXPECT_EQ(files::read_text_file(out / "previous_1.before/map.png"), "old");
  EXPECT_FALSE(exists(out / "previous_1"));
}

}  // namespace
}  // namespace echomap::apps
