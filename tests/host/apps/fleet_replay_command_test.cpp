// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/host/apps/said_by_command_line.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/team_folder.hpp"

namespace echomap::apps {
namespace {

using testing::HasSubstr;

class FleetReplayCommand : public testing::Test {
 protected:
  FleetReplayCommand() { tests::write_team_folder(logs.path()); }

  Said replay(std::vector<std::string> more = {}) {
    std::vector<std::string> words{
        "fleet", "replay", logs.path().string(), "--headless", "--out", out.string()};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  nlohmann::json summary() const {
    return nlohmann::json::parse(files::read_text_file(out / "summary.json"));
  }

  tests::ScratchFolder logs;
  tests::ScratchFolder folder;
  std::filesystem::path out = folder / "team";
};

TEST_F(FleetReplayCommand, WritesATrajectoryOfEachRobotAndWhatItGained) {
  const Said said = replay();
  EXPECT_EQ(said.code, console::ExitCode::kOk) << said.err;
  const auto json = summary();
  EXPECT_EQ(json["outcome"], "finished");
  ASSERT_EQ(json["robots"].size(), 2U);
  const auto& second = json["robots"][1];
  EXPECT_EQ(second["robot"], 2);
  EXPECT_LT(second["rmse_joint_m"], second["rmse_alone_m"]);
  EXPECT_GT(second["gain_percent"], 40.0);
  EXPECT_GT(second["nees_joint"], 0.0);
  EXPECT_GT(json["gain_percent"], 30.0);
  const auto trajectory = exports::read_trajectory_tum(out / "trajectory_2.tum");
  ASSERT_EQ(trajectory.size(), second["poses"]);
  EXPECT_NEAR(trajectory.back().T_map_robot.x_m(), 8.3, 0.15);
  EXPECT_THAT(said.err, HasSubstr("2 robots were localized jointly"));
  EXPECT_THAT(said.err, HasSubstr("next: "));
}

TEST_F(FleetReplayCommand, PrintsTheSameReportOnStdout) {
  const Said said = replay({"--json", "-"});
  const auto printed = nlohmann::json::parse(said.out);
  EXPECT_EQ(printed, summary());
}

TEST_F(FleetReplayCommand, WithoutTruthAfterTheStartFiguresAreNull) {
  for (const char* file : {"Robot1_Groundtruth.dat", "Robot2_Groundtruth.dat"}) {
    files::write_text_file(logs / file, "999.8 0 0 0\n");
  }
  EXPECT_EQ(replay().code, console::ExitCode::kOk);
  EXPECT_TRUE(summary()["gain_percent"].is_null());
  EXPECT_TRUE(summary()["robots"][0]["rmse_joint_m"].is_null());
}

TEST_F(FleetReplayCommand, WithoutAStartItSaysWhatIsMissing) {
  std::filesystem::remove(logs / "Robot1_Groundtruth.dat");
  const Said said = replay();
  EXPECT_EQ(said.code, console::ExitCode::kRuntimeError);
  EXPECT_THAT(said.err, HasSubstr("robot 1 takes no part"));
  EXPECT_THAT(said.err, HasSubstr("next: put RobotN_Groundtruth.dat"));
}

TEST_F(FleetReplayCommand, DamagedAndMissingFilesAreNamed) {
  files::write_text_file(logs / "Robot2_Measurement.dat", "1000 72 1\n1001 72 1 0\n");
  Said said = replay();
  EXPECT_EQ(said.code, console::ExitCode::kRuntimeError);
  EXPECT_THAT(said.err, HasSubstr("Robot2_Measurement.dat:1: "));
  std::filesystem::remove(logs / "Robot2_Odometry.dat");
  said = replay({"--force"});
  EXPECT_EQ(said.code, console::ExitCode::kRuntimeError);
  EXPECT_THAT(said.err, HasSubstr("a team has at least two"));
}

TEST_F(FleetReplayCommand, ARunIsNotOverwrittenUnasked) {
  EXPECT_EQ(replay().code, console::ExitCode::kOk);
  EXPECT_EQ(replay().code, console::ExitCode::kUsage);
  EXPECT_EQ(replay({"--force", "--blind", "1"}).code, console::ExitCode::kOk);
  EXPECT_EQ(summary()["blind"], nlohmann::json::array({1}));
  EXPECT_EQ(summary()["robots"][0]["landmark_sightings"], 0);
}

TEST_F(FleetReplayCommand, ABlindRobotMustBeOneOfTheTeam) {
  const Said said = replay({"--blind", "9"});
  EXPECT_EQ(said.code, console::ExitCode::kUsage);
  EXPECT_THAT(said.err, HasSubstr("the logs have no robot 9, only 1, 2"));
}

}  // namespace
}  // namespace echomap::apps
