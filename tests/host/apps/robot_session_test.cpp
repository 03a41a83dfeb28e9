// SPDX-License-Identifier: MIT
#include "host/apps/robot_session.hpp"

#include <string>

#include <gtest/gtest.h>

#include "host/apps/exit_code.hpp"
#include "protocol/config_digest.hpp"
#include "tests/host/apps/session_on_a_cable.hpp"

namespace echomap::apps {
namespace {

using exploration::MotionResult;

class RobotSessionTest : public SessionOnACable {};

TEST_F(RobotSessionTest, SetsUpAndArmsAndDisarmsInTheEnd) {
  session->connect();
  EXPECT_EQ(protocol::config_digest(cable.robot.configuration),
            protocol::config_digest(profile.configuration));
  EXPECT_TRUE(cable.robot.armed);
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kReached);
  EXPECT_EQ(cable.robot.moves_done.size(), 1U);
  session.reset();
  EXPECT_FALSE(cable.robot.armed);
}

TEST_F(RobotSessionTest, NamesTheFirmwareThatSpeaksAnotherProtocol) {
  cable.robot.schema_digest ^= 1U;
  cable.robot.schema = {};
  cable.robot.power_on(1);
  try {
    session->connect();
    FAIL() << "connected";
  } catch (const CommandError& error) {
    EXPECT_EQ(error.code(), ExitCode::kFirmwareMismatch);
  }
}

TEST_F(RobotSessionTest, JoinsARobotThatRunsWhereItMustNotBeReset) {
  cable.robot.power_on(5, protocol::kResetExternal);
  for (int ms = 0; ms < 90'000; ++ms) {
    cable.robot.advance_1ms();
  }
  session = new_session(true);
  session->connect();
  EXPECT_GT(cable.robot.stamp_us(), 90'000'000U);
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kReached);
}

TEST_F(RobotSessionTest, RefusesARobotThatOpeningHasReset) {
  session = new_session(true);
  cable.powered = false;
  after_ms(200, [this] {
    cable.robot.power_on(2, protocol::kResetExternal);
    cable.powered = true;
  });
  try {
    session->connect();
    FAIL() << "connected";
  } catch (const CommandError& error) {
    EXPECT_EQ(error.code(), ExitCode::kNoRobot);
    EXPECT_NE(std::string(error.what()).find("has reset the robot"), std::string::npos);
  }
  EXPECT_FALSE(cable.robot.armed);
}

TEST_F(RobotSessionTest, DoesASweepAgainThatAResetBrokeOff) {
  session->connect();
  cable.robot.motion_ms = 1000;
  after_ms(300, [this] { pull_power_and_start_anew(); });
  EXPECT_EQ(session->execute(exploration::Sweep{-1.0, 1.0, 0.1, 0.0}), MotionResult::kReached);
  EXPECT_EQ(cable.robot.sweeps, 2);
  EXPECT_TRUE(cable.robot.armed);
}

}  // namespace
}  // namespace echomap::apps
