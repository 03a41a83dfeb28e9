// SPDX-License-Identifier: MIT
#include "host/apps/resumed_run.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/apps/saved_map.hpp"
#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "host/session/pipeline_setup.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::apps {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class ResumedRunTest : public ::testing::Test {
 protected:
  void record(const std::string& lines) {
    files::write_text_file(run / kRecordName, "kind,stamp_us,values\n" + lines);
  }
  void summarise(const std::string& json) { files::write_text_file(run / "summary.json", json); }
  std::optional<ResumedRun> resume() { return resume_run(run.path(), profile, sessions, atlas); }

  const tests::ScratchFolder run;
  const session::RobotProfile profile = session::load_robot_profile("uno_2wd");
  pipeline::RobotAtlas atlas = session::atlas_for(profile, "none");
  pipeline::JoinedSessions sessions{atlas};
};

TEST_F(ResumedRunTest, IsNoneWhereNoneIsNamed) {
  EXPECT_FALSE(resume_run("", profile, sessions, atlas));
}

TEST_F(ResumedRunTest, GoesOnWithItsMapFromWhereItHasEnded) {
  record("odometry,1000,0.5,0.5\nbegin-scan\nsonar,2000,0.5,0.5,0,1\n");
  summarise(R"({"robot": "uno_2wd", "sim_seconds": 56.5})");
  const auto resumed = resume();
  ASSERT_TRUE(resumed);
  EXPECT_EQ(resumed->stops, 1U) << "the open scan is ended";
  EXPECT_EQ(resumed->sim_seconds, 56.5);
  sessions.on_odometry({time::RobotTime(std::chrono::microseconds(7)), {3.0, 3.0}});
  sessions.on_odometry({time::RobotTime(std::chrono::microseconds(9)), {3.25, 3.25}});
  const auto latest = atlas.pipeline().snapshot().latest;
  EXPECT_EQ(latest.stamp.time_since_epoch().count(), 2002);
  EXPECT_NEAR(latest.T_map_robot.x_m(), 0.75, 1e-12);
}

TEST_F(ResumedRunTest, LeavesOutHalfALineAtTheEndOfTheRecord) {
  record("odometry,1000,0.5,0.5\nbegin-scan\nend-scan\nodometry,2000,0.75,0.7");
  summarise(R"({"robot": "uno_2wd", "sim_seconds": 56.5})");
  ASSERT_TRUE(resume());
  EXPECT_EQ(atlas.pipeline().snapshot().trajectory->size(), 1U);
}

TEST_F(ResumedRunTest, KnowsTheMapsThatTheRobotWasCarriedAwayFrom) {
  const std::string previous = "kind,stamp_us,values\nodometry,500,0.5,0.5\nbegin-scan\nend-scan\n";
  record("carried,900,0.5,0.5,0,0,0\nodometry,1000,0.6,0.6\n");
  summarise(R"({"robot": "uno_2wd", "sim_seconds": 56.5})");
  for (std::size_t number : {1U, 2U}) {
    std::filesystem::create_directories(previous_map_of(run.path(), number));
    files::write_text_file(previous_map_of(run.path(), number) / kRecordName, previous);
  }
  ASSERT_TRUE(resume());
  ASSERT_EQ(atlas.previous_maps().size(), 2U);
  EXPECT_EQ(atlas.previous_maps().front().record.scans(), 1U);
  EXPECT_NEAR(atlas.pipeline().snapshot().latest.T_map_robot.x_m(), 0.1, 1e-12);
}

TEST_F(ResumedRunTest, PlaysTheLaterMapsWhereAnEarlierOneIsDamaged) {
  record("odometry,1000,0.6,0.6\n");
  const std::string header = "kind,stamp_us,values\n";
  const std::string stop = "odometry,500,0.5,0.5\nbegin-scan\nend-scan\n";
  std::size_t number = 0;
  for (const std::string& lines : {stop + "odometry,1\n", std::string("odometry,1\n"), stop}) {
    const auto folder = previous_map_of(run.path(), ++number);
    std::filesystem::create_directories(folder);
    files::write_text_file(folder / kRecordName, header + lines);
  }
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { play_run(run.path(), atlas, atlas); }),
              AllOf(HasSubstr("previous_1/observations.csv:5"),
                    HasSubstr("previous_2/observations.csv:2"),
                    ::testing::Not(HasSubstr("previous_3"))));
  ASSERT_EQ(atlas.previous_maps().size(), 3U);
  EXPECT_EQ(atlas.previous_maps()[0].record.scans(), 1U) << "up to the damage";
  EXPECT_EQ(atlas.previous_maps()[1].record.scans(), 0U);
  EXPECT_EQ(atlas.previous_maps()[2].record.scans(), 1U);
}

TEST_F(ResumedRunTest, NeedsARecordWithARobotsWay) {
  summarise(R"({"robot": "uno_2wd", "sim_seconds": 1})");
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { resume(); }),
              AllOf(HasSubstr("it has no observations.csv"), HasSubstr("next: ")));
  record("");
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { resume(); }),
              AllOf(HasSubstr("its record is empty"), HasSubstr("next: ")));
}

TEST_F(ResumedRunTest, RefusesAnotherRobot) {
  record("odometry,1000,0.5,0.5\n");
  summarise(R"({"robot": "ev3", "sim_seconds": 1})");
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { resume(); }),
              AllOf(HasSubstr("its robot is 'ev3', not 'uno_2wd'"), HasSubstr("next: ")));
}

TEST_F(ResumedRunTest, RefusesARunInWhichTheRobotWasLifted) {
  record("odometry,1000,0.5,0.5\nhazards,2000,0,0,0,0,0,0,1,0,0\n");
  summarise(R"({"robot": "uno_2wd", "sim_seconds": 1})");
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { resume(); }),
              AllOf(HasSubstr("the robot was lifted during the run"), HasSubstr("next: ")));
}

TEST_F(ResumedRunTest, NamesTheFileThatIsDamaged) {
  record("odometry,1000,0.5\n");
  for (const char* json : {"", "[]", R"({"robot": 7, "sim_seconds": 1})", R"({"robot": "x"})"}) {
    summarise(json);
    EXPECT_THAT(tests::thrown_text<files::FileError>([&] { resume(); }),
                HasSubstr("summary.json: not the summary of a run"))
        << json;
  }
  summarise(R"({"robot": "uno_2wd", "sim_seconds": 1})");
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { resume(); }),
              HasSubstr("observations.csv:2: the right wheel is missing"));
}

}  // namespace
}  // namespace echomap::apps
