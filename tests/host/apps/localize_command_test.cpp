// SPDX-License-Identifier: MIT
#include <cmath>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::apps {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// The map that a log makes, and the same log once more.
class LocalizeCommandTest : public ::testing::Test {
 protected:
  LocalizeCommandTest() {
    ReplayOptions replay;
    replay.log = fs::path(ECHOMAP_SOURCE_DIR) / "tests/data/small_room.clf";
    replay.out = scratch_ / "map";
    replay.headless = true;
    run_replay(replay);
    options_.log = replay.log;
    options_.map = replay.out;
    options_.run.out = scratch_ / "run";
    options_.run.headless = true;
  }
  nlohmann::json summary() const {
    return nlohmann::json::parse(files::read_text_file(options_.run.out / "summary.json"));
  }
  std::string error() {
    return tests::thrown_text<std::runtime_error>([&] { run_localize(options_); });
  }

  tests::ScratchFolder scratch_;
  LocalizeOptions options_;
};

TEST_F(LocalizeCommandTest, FollowsARobotThatBeginsWhereItIsTold) {
  options_.at = {0.0, 0.0, 0.0};
  ASSERT_EQ(run_localize(options_), ExitCode::kOk);
  EXPECT_EQ(summary()["outcome"], "finished");
  EXPECT_EQ(summary()["status"], "localized");
  EXPECT_LT(summary()["lost_probability"], 0.1);
  const auto found = exports::read_trajectory_tum(options_.run.out / "trajectory.tum").back();
  const auto mapped = exports::read_trajectory_tum(options_.map / "trajectory.tum").back();
  EXPECT_LT((found.T_map_robot.position_m() - mapped.T_map_robot.position_m()).norm(), 0.15);
}

TEST_F(LocalizeCommandTest, TakesAYamlFileForAMap) {
  options_.map /= "map.yaml";
  EXPECT_EQ(run_localize(options_), ExitCode::kOk);
  EXPECT_FALSE(summary()["hypotheses"].empty());
}

TEST_F(LocalizeCommandTest, FollowsTheRobotOfARunDirectory) {
  ReplayOptions replay;
  replay.log = options_.log;
  replay.map = "points";
  replay.out = scratch_ / "points";
  replay.headless = true;
  run_replay(replay);
  options_.log = replay.out;
  options_.at = {0.0, 0.0, 0.0};
  ASSERT_EQ(run_localize(options_), ExitCode::kOk);
  EXPECT_EQ(summary()["status"], "localized");
  const auto mapped = exports::read_trajectory_tum(options_.map / "trajectory.tum").back();
  const nlohmann::json place = summary()["hypotheses"][0];
  EXPECT_LT(std::hypot(place["x_m"].get<double>() - mapped.T_map_robot.x_m(),
                       place["y_m"].get<double>() - mapped.T_map_robot.y_m()),
            0.15);
}

TEST_F(LocalizeCommandTest, ADamagedLogKeepsItsTrajectoryUpToThere) {
  const std::string whole = files::read_text_file(options_.log);
  const std::size_t middle = whole.find('\n', whole.size() / 2) + 100;
  options_.log = scratch_ / "damaged.clf";
  files::write_text_file(options_.log, whole.substr(0, middle) + "\n");
  options_.at = {0.0, 0.0, 0.0};
  EXPECT_EQ(run_localize(options_), ExitCode::kRuntimeError);
  EXPECT_EQ(summary()["outcome"], "log-damaged");
  EXPECT_EQ(summary()["status"], "localized");
  EXPECT_GT(exports::read_trajectory_tum(options_.run.out / "trajectory.tum").size(), 5U);
}

TEST_F(LocalizeCommandTest, SaysWhatIsWrongWithItsInputs) {
  files::write_text_file(scratch_ / "still.clf", "ODOM 0 0 0 0 0 0 1 here 1\n");
  options_.log = scratch_ / "still.clf";
  EXPECT_THAT(error(), HasSubstr("holds no ranges"));
  options_.map = scratch_ / "nowhere.yaml";
  EXPECT_THAT(error(), HasSubstr("nowhere.yaml"));
}

}  // namespace
}  // namespace echomap::apps
