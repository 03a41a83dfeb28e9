// SPDX-License-Identifier: MIT
#include "host/apps/recorded_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/pipeline/observation_log.hpp"
#include "host/recording/session_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"
#include "tests/support/written_recording.hpp"

namespace echomap::apps {
namespace {

using ::testing::HasSubstr;

class RecordedRunTest : public ::testing::Test {
 protected:
  RecordedRunTest() {
    recording.add_stop(1.0);
    recording.add_stop(1.2);
    recording.save(file);
  }
  Played play_all(
      const PlayedPart& part = {}, const std::function<void()>& on_stop = [] {}) {
    recording::SessionReader reader(file);
    pipeline::JoinedSessions sessions(log);
    return play(reader, profile_of(reader), {sessions, log}, part, on_stop);
  }

  const tests::ScratchFolder scratch;
  const std::filesystem::path file = scratch / recording::kSessionFileName;
  const session::RobotProfile profile = session::load_robot_profile("uno_2wd");
  tests::WrittenRecording recording{profile};
  pipeline::ObservationLog log;
};

TEST_F(RecordedRunTest, IsInARunDirectoryOrAlone) {
  EXPECT_EQ(recording_of(scratch.path()), file);
  EXPECT_EQ(recording_of(file), file);
  EXPECT_FALSE(recording_of(scratch / "none"));
  files::write_text_file(scratch / "map.yaml", "");
  EXPECT_FALSE(recording_of(scratch / "map.yaml"));
}

TEST_F(RecordedRunTest, PlaysWhatTheRobotSensed) {
  int stops = 0;
  const Played played = play_all({}, [&] { ++stops; });
  EXPECT_EQ(played.damage, "");
  EXPECT_EQ(stops, 2);
  EXPECT_EQ(log.scans(), 2U);
  EXPECT_EQ(log.observations(), 68U);
  EXPECT_NEAR(played.duration_s, 0.32, 1e-9);
}

TEST_F(RecordedRunTest, PlaysAPart) {
  play_all({.until_s = 0.1});
  EXPECT_EQ(log.scans(), 0U);
  EXPECT_GT(log.observations(), 0U);
}

TEST_F(RecordedRunTest, HasTheReportOfTheRunOrWhatItSetOutToDo) {
  recording::SessionReader reader(file);
  RunReport report = read_report(file, reader);
  EXPECT_EQ(report.slam, "multiscan");
  EXPECT_EQ(report.robot, "uno_2wd");
  EXPECT_EQ(report.json.at("finished"), false);
  files::write_text_file(scratch / "summary.json",
                         R"({"slam": "ekf", "outline_by_strategy": false, "world": "attic"})");
  report = read_report(scratch.path(), reader);
  EXPECT_EQ(report.slam, "ekf") << "that beside it";
  EXPECT_EQ(report.world, "attic");
}

TEST_F(RecordedRunTest, NeedsTheProfileOfTheRobot) {
  recording::SessionRecorder bare({});
  bare.begin_session(0);
  bare.open(file);
  bare.finish();
  const recording::SessionReader reader(file);
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { profile_of(reader); }),
              HasSubstr("the robot's profile is missing"));
}

}  // namespace
}  // namespace echomap::apps
