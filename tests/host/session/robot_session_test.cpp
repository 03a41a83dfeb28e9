// SPDX-License-Identifier: MIT
#include "host/session/robot_session.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "protocol/config_digest.hpp"
#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::session {
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

TEST_F(RobotSessionTest, ArmsAgainForAMotionAfterItHasDisarmed) {
  session->connect();
  session->disarm();
  EXPECT_FALSE(cable.robot.armed);
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kReached);
  EXPECT_TRUE(cable.robot.armed);
  session.reset();
  EXPECT_FALSE(cable.robot.armed);
}

TEST_F(RobotSessionTest, GivesARobotItsTimeHoweverLongItsPortWasLookedFor) {
  cable.begin = time::HostTime(std::chrono::seconds(10));
  cable.powered = false;
  session = new_session(false);
  after_ms(12'500, [this] {
    cable.robot.power_on(2);
    cable.powered = true;
  });
  EXPECT_NO_THROW(session->connect());
  EXPECT_TRUE(cable.robot.armed);
}

TEST_F(RobotSessionTest, CallsNobodyBackWhileItIsDestroyed) {
  session->connect();
  int steps = 0;
  session->on_step = [&] { ++steps; };
  session.reset();
  EXPECT_EQ(steps, 0);
  EXPECT_FALSE(cable.robot.armed);
}

TEST_F(RobotSessionTest, NamesTheFirmwareThatSpeaksAnotherProtocol) {
  cable.robot.schema_digest ^= 1U;
  cable.robot.schema = {};
  cable.robot.power_on(1);
  try {
    session->connect();
    FAIL() << "connected";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kFirmwareMismatch);
  }
}

/// Of a robot's 71.6 minutes the second half has stamps that lie in the future as 32-bit numbers.
class LongRunningRobot : public SessionOnACable, public testing::WithParamInterface<int> {};

TEST_P(LongRunningRobot, IsJoinedWhereItMustNotBeReset) {
  cable.robot.power_on(5, protocol::kResetExternal);
  cable.robot.run_unheard_ms(GetParam() * 1000);
  session = new_session(true);
  session->connect();
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kReached);
}

INSTANTIATE_TEST_SUITE_P(Seconds, LongRunningRobot, testing::Values(90, 30 * 60, 50 * 60, 70 * 60));

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
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kNoRobot);
    EXPECT_NE(std::string(error.what()).find("has reset the robot"), std::string::npos);
  }
  EXPECT_FALSE(cable.robot.armed);
}

TEST_F(RobotSessionTest, EndsWhereABoardThatWasResetTakesItsProfileNoMore) {
  session->connect();
  after_ms(50, [this] {
    power_cycle();
    cable.robot.answer = protocol::CommandStatus::kOutOfRange;
  });
  EXPECT_NO_THROW(session->execute(exploration::Drive{0.1}));
  EXPECT_NO_THROW(session->execute(exploration::Drive{0.1}));
  EXPECT_EQ(session->end(), SessionEnd::kConfigInvalid);
  EXPECT_NE(session->end_reason().find("refuses Configure"), std::string::npos);
}

TEST_F(RobotSessionTest, EndsAtOnceWhereABoardComesBackWithOtherFirmware) {
  session->connect();
  after_ms(50, [this] {
    cable.robot.protocol_major = 9;
    power_cycle();
  });
  session->execute(exploration::Drive{0.1});
  session->execute(exploration::Drive{0.1});
  EXPECT_EQ(session->end(), SessionEnd::kFirmwareMismatch);
  EXPECT_NE(session->end_reason().find("protocol 9."), std::string::npos) << session->end_reason();
  EXPECT_LT(session->now(), time::HostTime(std::chrono::seconds(2)));
}

TEST_F(RobotSessionTest, SetsARobotUpAgainThatIsFoundDisarmed) {
  session->connect();
  cable.robot.needs_arming = true;
  cable.robot.armed = false;
  EXPECT_EQ(session->execute(exploration::Drive{0.1}), MotionResult::kInterrupted);
  EXPECT_EQ(session->execute(exploration::Drive{0.1}), MotionResult::kReached);
  EXPECT_TRUE(cable.robot.armed);
}

TEST_F(RobotSessionTest, WaitsForThePredecessorThatWasKilledToBeForgotten) {
  cable.robot.hear_of_another(protocol::Hello{1, 3, 0, 99});
  session->connect();
  EXPECT_TRUE(cable.robot.armed);
  EXPECT_LT(session->now(), time::HostTime(std::chrono::milliseconds(3500)));
}

TEST_F(RobotSessionTest, LeavesARobotToTheProgramThatHoldsIt) {
  session->on_step = [this] { cable.robot.hear_of_another(protocol::KeepAlive{200}); };
  cable.robot.hear_of_another(protocol::Hello{1, 3, 0, 0x99});
  try {
    session->connect();
    FAIL() << "another program holds it";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kNoRobot);
    EXPECT_THAT(error.what(), testing::HasSubstr("holds the robot on cable (session 0099)"));
    EXPECT_THAT(error.what(), testing::HasSubstr("--take-over"));
  }
  EXPECT_LT(session->now(), time::HostTime(std::chrono::milliseconds(4500)));
  EXPECT_EQ(cable.robot.session(), 0x99);
}

TEST_F(RobotSessionTest, EndsWithoutAWordToARobotThatWasTakenOver) {
  session->connect();
  cable.robot.motion_ms = 3000;
  after_ms(300, [this] { cable.robot.hear_of_another(protocol::TakeOver{0x99}); });
  session->execute(exploration::Drive{0.2});
  EXPECT_EQ(session->end(), SessionEnd::kTakenOver);
  EXPECT_EQ(exit_code_of(*session->end()), console::ExitCode::kNoRobot);
  EXPECT_THAT(session->end_reason(), testing::HasSubstr("has taken the robot on cable over"));
  const int hellos = cable.robot.hellos;
  const auto commands = cable.robot.command_ids_received.size();
  cable.robot.hear_of_another(protocol::Arm{1, 1});
  session.reset();
  EXPECT_TRUE(cable.robot.armed);
  EXPECT_EQ(cable.robot.hellos, hellos);
  EXPECT_EQ(cable.robot.command_ids_received.size(), commands + 1);
}

TEST_F(RobotSessionTest, DoesASweepAgainThatAResetBrokeOff) {
  session->connect();
  cable.robot.motion_ms = 1000;
  after_ms(300, [this] { power_cycle(); });
  EXPECT_EQ(session->execute(exploration::Sweep{-1.0, 1.0, 0.1, 0.0}), MotionResult::kReached);
  EXPECT_EQ(cable.robot.sweeps, 2);
  EXPECT_TRUE(cable.robot.armed);
}

}  // namespace
}  // namespace echomap::session
