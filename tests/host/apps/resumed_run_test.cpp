// SPDX-License-Identifier: MIT
#include "host/apps/resumed_run.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/exports/observations_csv.hpp"
#include "host/files/atomic_file.hpp"
#include "host/pipeline/observation_log.hpp"
#include "host/recording/session_file.hpp"
#include "tests/support/played_recording.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"
#include "tests/support/written_recording.hpp"

namespace echomap::apps {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class ResumedRunTest : public ::testing::Test {
 protected:
  ResumedRunTest() { robot.begin_maps("none"); }
  void save() { recording.save(run / recording::kSessionFileName); }
  std::optional<ResumedRun> resume() { return resume_run(run.path(), robot); }

  const tests::ScratchFolder run;
  const session::RobotProfile profile = session::load_robot_profile("uno_2wd");
  session::RobotContext robot{profile, session::Seed(1)};
  tests::WrittenRecording recording{profile};
};

TEST_F(ResumedRunTest, IsNoneWhereNoneIsNamed) { EXPECT_FALSE(resume_run("", robot)); }

TEST_F(ResumedRunTest, GoesOnWithItsMapFromWhereItHasEnded) {
  recording.receive(protocol::Odometry{1000, 3000, 3000, 0});
  recording.receive(protocol::Odometry{2000, 3500, 3500, 0});
  recording.add(recording::SessionEventKind::kBeginScan);
  recording.receive(protocol::Echo{3000, 0, 5800, 3500, 3500});
  save();
  const auto resumed = resume();
  ASSERT_TRUE(resumed);
  EXPECT_EQ(resumed->stops, 1U) << "the open scan is ended";
  EXPECT_NEAR(resumed->sim_seconds, 0.015, 1e-9);
  const double before_m = robot.atlas().pipeline().snapshot().latest.T_map_robot.x_m();
  EXPECT_GT(before_m, 0.0);
  robot.sessions().on_odometry({time::RobotTime(std::chrono::microseconds(7)), {3.0, 3.0}});
  robot.sessions().on_odometry({time::RobotTime(std::chrono::microseconds(9)), {3.25, 3.25}});
  const auto latest = robot.atlas().pipeline().snapshot().latest;
  EXPECT_EQ(latest.stamp.time_since_epoch().count(), 3002);
  EXPECT_NEAR(latest.T_map_robot.x_m(), before_m + 0.25, 1e-12);
}

TEST_F(ResumedRunTest, RecordsAgainWhatItPlays) {
  recording.add_stop(1.0);
  recording.add_stop(1.2);
  save();
  ASSERT_TRUE(resume());
  robot.recorder().open(run / "again.mcap");
  robot.recorder().finish();
  pipeline::ObservationLog played;
  pipeline::ObservationLog again;
  tests::play_recording(run / recording::kSessionFileName, played);
  tests::play_recording(run / "again.mcap", again);
  exports::ObservationsCsv played_table;
  exports::ObservationsCsv again_table;
  played.replay(played_table);
  again.replay(again_table);
  played_table.save(run / "played.csv");
  again_table.save(run / "again.csv");
  EXPECT_EQ(files::read_text_file(run / "played.csv"), files::read_text_file(run / "again.csv"));
  EXPECT_EQ(again.scans(), 2U);
}

TEST_F(ResumedRunTest, ReadsTheRecordingOfAProgramThatWasKilled) {
  recording.add_stop(1.0);
  save();
  const std::string bytes = files::read_text_file(run / recording::kSessionFileName);
  files::write_text_file(run / recording::kSessionFileName, bytes.substr(0, bytes.size() - 50));
  ASSERT_TRUE(resume());
  EXPECT_EQ(robot.atlas().pipeline().snapshot().stops, 1U);
}

TEST_F(ResumedRunTest, KnowsTheMapsThatTheRobotWasCarriedAwayFrom) {
  for (const double range_m : {1.0, 1.2, 1.0, 1.1}) {
    recording.add_stop(range_m);
  }
  recording.add(recording::SessionEventKind::kBeginNewMap, 2);
  recording.add_stop(1.0);
  save();
  ASSERT_TRUE(resume());
  ASSERT_EQ(robot.atlas().previous_maps().size(), 1U);
  EXPECT_EQ(robot.atlas().previous_maps().front().record.scans(), 2U);
}

TEST_F(ResumedRunTest, NeedsARecordingWithARobotsPath) {
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { resume(); }),
              AllOf(HasSubstr("it has no session.mcap"), HasSubstr("next: ")));
  files::write_text_file(run / "observations.csv", "");
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { resume(); }),
              HasSubstr("an earlier version of echomap made it"));
  save();
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { resume(); }),
              AllOf(HasSubstr("its recording is empty"), HasSubstr("next: ")));
}

TEST_F(ResumedRunTest, RefusesAnotherRobot) {
  tests::WrittenRecording other(session::load_robot_profile("ev3"));
  other.save(run / recording::kSessionFileName);
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { resume(); }),
              AllOf(HasSubstr("its robot is 'ev3', not 'uno_2wd'"), HasSubstr("next: ")));
}

TEST_F(ResumedRunTest, RefusesARunInWhichTheRobotWasLifted) {
  recording.receive(protocol::Odometry{1000, 3000, 3000, 0});
  recording.receive(protocol::Status{2000, 0, protocol::kHazardWheelDrop, 0, 0, 0, 0});
  save();
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { resume(); }),
              AllOf(HasSubstr("the robot was lifted during the run"), HasSubstr("next: ")));
}

TEST_F(ResumedRunTest, NamesTheFileThatIsDamaged) {
  recording.add_stop(1.0);
  save();
  std::string bytes = files::read_text_file(run / recording::kSessionFileName);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  files::write_text_file(run / recording::kSessionFileName, bytes);
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { resume(); }),
              HasSubstr("session.mcap: byte "));
}

}  // namespace
}  // namespace echomap::apps
