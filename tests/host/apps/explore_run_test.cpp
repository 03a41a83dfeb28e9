// SPDX-License-Identifier: MIT
#include "host/apps/explore_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/session/temporary_folder.hpp"
#include "host/strategies/strategy_setup.hpp"
#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::apps {
namespace {

RunOptions options_for(const char* robot) {
  RunOptions options;
  options.robot = robot;
  options.strategy.stops = 1;
  options.headless = true;
  return options;
}

TEST(ProfileFor, IsOfARobotThatTheStrategyCanUse) {
  EXPECT_EQ(profile_for(options_for("uno_2wd")).name, "uno_2wd");
  try {
    profile_for(options_for("create"));
    FAIL() << "it has no sonar";
  } catch (const CommandError& error) {
    EXPECT_EQ(error.code(), ExitCode::kConfigInvalid);
    EXPECT_THAT(error.what(), testing::HasSubstr("needs a sonar"));
    EXPECT_THAT(error.what(), testing::HasSubstr("next: "));
  }
}

class ExploreRun : public session::SessionOnACable {
 protected:
  ExitCode explore() {
    return explore_and_save(
        {*session, atlas, profile}, options_for("uno_2wd"), folder.path(), summary);
  }

  const session::TemporaryFolder folder;
  pipeline::RobotAtlas atlas = session::atlas_for(profile, "none");
  exports::RunSummary summary;
};

TEST_F(ExploreRun, ThrowsWhereTheBoardDoesNotTakeTheProfileAndLeavesItDisarmed) {
  cable.robot.answer = protocol::CommandStatus::kOutOfRange;
  EXPECT_THROW(explore(), CommandError);
  EXPECT_FALSE(cable.robot.armed);
}

TEST_F(ExploreRun, SavesTheMapWhereTheBoardTakesItsProfileNoMore) {
  cable.robot.on_command = [this](std::string_view name) {
    if (name == "StartSweep" && restarts == 0) {
      pull_power_and_start_anew();
      cable.robot.answer = protocol::CommandStatus::kOutOfRange;
    }
  };
  EXPECT_EQ(explore(), ExitCode::kConfigInvalid);
  EXPECT_EQ(summary.outcome, "configuration-invalid");
  EXPECT_EQ(summary.firmware, "echomap 0.1.0");
  EXPECT_EQ(summary.link.resets, 1U);
  EXPECT_GT(summary.link.frames_received, 0U);
  EXPECT_TRUE(std::filesystem::exists(folder / "summary.json"));
}

TEST_F(ExploreRun, SavesTheMapWhereTheRobotIsLiftedAndNotPutDownAgain) {
  may_be_lifted = true;
  session = new_session(false);
  cable.robot.on_command = [this](std::string_view name) {
    if (name == "StartSweep") {
      cable.robot.hazards = protocol::kHazardWheelDrop;
      cable.robot.armed = false;
    }
  };
  EXPECT_EQ(explore(), ExitCode::kSafetyStop);
  EXPECT_EQ(summary.outcome, "safety-stop");
  EXPECT_GT(summary.sim_seconds, 300.0);
  EXPECT_LT(summary.sim_seconds, 330.0);
  EXPECT_TRUE(std::filesystem::exists(folder / "map.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "observations.csv"));
}

}  // namespace
}  // namespace echomap::apps
