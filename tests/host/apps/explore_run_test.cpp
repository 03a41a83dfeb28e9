// SPDX-License-Identifier: MIT
#include "host/apps/explore_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/session/temporary_folder.hpp"
#include "host/strategies/strategy_setup.hpp"
#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::apps {
namespace {

using console::ExitCode;

strategies::StrategyOptions one_stop() {
  strategies::StrategyOptions strategy;
  strategy.stops = 1;
  return strategy;
}

TEST(ProfileFor, IsOfARobotThatTheStrategyCanUse) {
  EXPECT_EQ(profile_for("uno_2wd", one_stop()).name, "uno_2wd");
  try {
    profile_for("create", one_stop());
    FAIL() << "it has no sonar";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), ExitCode::kConfigInvalid);
    EXPECT_THAT(error.what(), testing::HasSubstr("needs a sonar"));
    EXPECT_THAT(error.what(), testing::HasSubstr("next: "));
  }
}

class ExploreAndSave : public session::SessionOnACable {
 protected:
  ExitCode explore() {
    begin_maps(robot, "", "none");
    robot.open({new_connection(), nullptr});
    return explore_and_save(robot, {strategy, live, folder.path(), ProgressDisplay::kNone}, summary)
        .code;
  }

  const session::TemporaryFolder folder;
  const strategies::StrategyOptions strategy = one_stop();
  session::RobotContext robot{profile, session::Seed(1)};
  LiveRun live{LiveOptions(), robot, {}};
  exports::RunSummary summary;
};

TEST_F(ExploreAndSave, ThrowsWhereTheBoardDoesNotTakeTheProfileAndLeavesItDisarmed) {
  cable.robot.answer = protocol::CommandStatus::kOutOfRange;
  EXPECT_THROW(explore(), console::CommandError);
  EXPECT_FALSE(cable.robot.armed);
}

TEST_F(ExploreAndSave, SavesTheMapWhereTheBoardTakesItsProfileNoMore) {
  cable.robot.on_command = [this](std::string_view name) {
    if (name == "StartSweep" && restarts == 0) {
      power_cycle();
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

TEST_F(ExploreAndSave, SavesTheMapWhereTheRobotIsLiftedAndNotPutDownAgain) {
  may_be_lifted = true;
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
  EXPECT_TRUE(std::filesystem::exists(folder / "session.mcap"));
}

}  // namespace
}  // namespace echomap::apps
