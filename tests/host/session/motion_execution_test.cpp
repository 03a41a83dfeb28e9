// SPDX-License-Identifier: MIT
#include "host/session/motion_execution.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::session {
namespace {

using exploration::MotionResult;

/// Motions of a session's robot.
class MotionExecutionTest : public SessionOnACable {};

TEST_F(MotionExecutionTest, TellsWhatTheBoardStoppedFor) {
  session->connect();
  cable.robot.outcome = protocol::MotionOutcome::kHazard;
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kHazard);
  EXPECT_FALSE(session->end()) << "a cliff is an obstacle like another";
  cable.robot.outcome = protocol::MotionOutcome::kRunaway;
  session->execute(exploration::Drive{0.2});
  EXPECT_EQ(session->end(), SessionEnd::kSafetyStop);
}

TEST_F(MotionExecutionTest, TellsABlockedMoveByWhatBlocksIt) {
  profile.configuration.safety.hazard_stops = protocol::kHazardCliffLeft;
  session = new_session(false);
  session->connect();
  cable.robot.answer = protocol::CommandStatus::kBlocked;
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kBumped);
  cable.robot.hazards = protocol::kHazardWall;
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kBumped);
  cable.robot.hazards = protocol::kHazardCliffLeft;
  session->execute(exploration::Drive{0.2});
  session->execute(exploration::Drive{0.2});
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kHazard);
}

/// A stepper that turns 5 degrees a second takes 40 s for 20 pings.
TEST_F(MotionExecutionTest, GivesASlowPanItsTime) {
  profile.configuration.pan.deg_per_s = 5;
  session = new_session(false);
  session->connect();
  cable.robot.motion_ms = 40'000;
  EXPECT_EQ(session->execute(exploration::Sweep{-1.0, 1.0, 0.1, 0.0}), MotionResult::kReached);
}

/// As the NXT's sonar on an EV3, with the way of the pan between two of 73 pings.
TEST_F(MotionExecutionTest, GivesASensorThatMeasuresByItselfItsTime) {
  session->connect();
  cable.robot.motion_ms = 73 * 300;
  EXPECT_EQ(session->execute(exploration::Sweep{-1.57, 1.57, 3.14 / 72.0, 0.02}),
            MotionResult::kReached);
}

/// Commands are numbered anew in each session; the robot's last Status may be of an earlier one.
TEST_F(MotionExecutionTest, TakesNoEarlierSessionsSweepForItsOwn) {
  cable.robot.motion_ms = 500;
  session->connect();  // Sends the configuration, which those behind it need not.
  for (int i = 0; i < 3; ++i) {
    session = new_session(false);
    session->connect();
    session->execute(exploration::Stand{0.5});  // Hears how the last sweep ended.
    const auto start = session->now();
    EXPECT_EQ(session->execute(exploration::Sweep{-1.0, 1.0, 0.1, 0.0}), MotionResult::kReached);
    EXPECT_GE(session->now() - start, std::chrono::milliseconds(500)) << "session " << i;
  }
}

TEST_F(MotionExecutionTest, RollsBySetpointsAndStopsBeforeAnyOtherMotion) {
  session->connect();
  std::vector<std::string> commands;
  cable.robot.on_command = [&](std::string_view name) { commands.emplace_back(name); };
  const auto start = session->now();
  EXPECT_EQ(session->execute(exploration::Roll{0.1, 0.5, 0.5}), MotionResult::kReached);
  EXPECT_GE(session->now() - start, std::chrono::milliseconds(500));
  EXPECT_GE(cable.robot.keep_alives.size(), 2U) << "it outlives its time to live";
  EXPECT_EQ(session->execute(exploration::Roll{0.1, 0.0, 0.05}), MotionResult::kReached);
  EXPECT_TRUE(commands.empty());
  ASSERT_EQ(cable.robot.setpoints.size(), 2U);
  const auto arc = profile.geometry.arc_speeds(0.1, 0.5);
  EXPECT_EQ(cable.robot.setpoints[0].left_ticks_per_s, arc.left);
  EXPECT_EQ(cable.robot.setpoints[0].right_ticks_per_s, arc.right);
  EXPECT_EQ(session->execute(exploration::Drive{0.1}), MotionResult::kReached);
  EXPECT_EQ(commands, (std::vector<std::string>{"Stop", "MoveTicks"}));
  cable.robot.on_command = {};  // The session ends after this function has.
}

TEST_F(MotionExecutionTest, LooksAroundWhileTheWheelsTurnWhereItShall) {
  session->connect();
  std::vector<std::string> commands;
  cable.robot.on_command = [&](std::string_view name) { commands.emplace_back(name); };
  session->execute(exploration::Drive{0.1});
  EXPECT_EQ(commands, std::vector<std::string>{"MoveTicks"});

  session->look_around_on_the_way(true);
  commands.clear();
  session->execute(exploration::Drive{0.1});
  EXPECT_EQ(commands, (std::vector<std::string>{"StartSweep", "MoveTicks"}));
  commands.clear();
  session->execute(exploration::Sweep{-1.0, 1.0, 0.1, 0.0});
  EXPECT_EQ(commands, (std::vector<std::string>{"Stop", "StartSweep"}))
      << "a robot that still looks would refuse the sweep";

  cable.robot.motion_ms = 1000;
  commands.clear();
  session->execute(exploration::Roll{0.1, 0.0, 0.4});
  session->execute(exploration::Roll{0.1, 0.0, 0.4});
  EXPECT_EQ(commands, std::vector<std::string>{"StartSweep"}) << "one look at a time";
  session->execute(exploration::Roll{0.1, 0.0, 0.8});
  session->execute(exploration::Roll{0.1, 0.0, 0.1});
  EXPECT_EQ(commands, (std::vector<std::string>{"StartSweep", "StartSweep"}));
  cable.robot.on_command = {};  // The session ends after this function has.
}

TEST_F(MotionExecutionTest, DrivesOnWhereItCannotLook) {
  session->connect();
  session->look_around_on_the_way(true);
  cable.robot.answer = protocol::CommandStatus::kOutOfRange;
  EXPECT_EQ(session->execute(exploration::Roll{0.1, 0.0, 0.1}), MotionResult::kReached);
  EXPECT_EQ(cable.robot.setpoints.size(), 1U);
}

TEST_F(MotionExecutionTest, EndsARollByWhatItMeetsAndNotByWhatItHasTouchedBefore) {
  session->connect();
  after_ms(50, [this] {
    cable.robot.send(protocol::Odometry{
        cable.robot.stamp_us(), 0, 0, protocol::kFlagArmed | protocol::kFlagBumpLeft});
  });
  const auto start = session->now();
  EXPECT_EQ(session->execute(exploration::Roll{0.1, 0.0, 1.0}), MotionResult::kBumped);
  EXPECT_LT(session->now() - start, std::chrono::milliseconds(200));
  EXPECT_EQ(session->execute(exploration::Roll{0.0, 1.0, 0.1}), MotionResult::kReached);
}

TEST_F(MotionExecutionTest, CallsARollInterruptedUnderWhichTheBoardWasReset) {
  session->connect();
  after_ms(50, [this] { power_cycle(); });
  EXPECT_EQ(session->execute(exploration::Roll{0.1, 0.0, 1.0}), MotionResult::kInterrupted);
}

TEST_F(MotionExecutionTest, GivesUpASweepThatDoesNotEnd) {
  session->connect();
  cable.robot.motion_ms = 60'000;
  EXPECT_EQ(session->execute(exploration::Sweep{-1.0, 1.0, 0.1, 0.0}), MotionResult::kTimedOut);
}

TEST_F(MotionExecutionTest, StopsASweepThatOutlastsABrokenLinkBeforeItIsDoneAgain) {
  patience = std::chrono::seconds(20);
  session = new_session(false);
  session->connect();
  cable.robot.motion_ms = 60'000;
  after_ms(100, [this] {
    cable.plugged = false;
    after_ms(8000, [this] {
      cable.plugged = true;
      cable.robot.motion_ms = 100;
    });
  });
  EXPECT_EQ(session->execute(exploration::Sweep{-0.1, 0.1, 0.1, 0.0}), MotionResult::kReached);
  EXPECT_EQ(cable.robot.sweeps, 2);
}

TEST_F(MotionExecutionTest, CallsAMoveInterruptedThatALinkBrokeOff) {
  patience = std::chrono::seconds(20);
  session = new_session(false);
  session->connect();
  after_ms(50, [this] {
    cable.plugged = false;
    after_ms(8000, [this] { cable.plugged = true; });
  });
  EXPECT_EQ(session->execute(exploration::Drive{0.02}), MotionResult::kInterrupted);
  EXPECT_EQ(session->execute(exploration::Drive{0.1}), MotionResult::kReached);
  EXPECT_FALSE(session->end());
}

TEST_F(MotionExecutionTest, DoesNotDoAMoveAgainThatAResetBrokeOff) {
  session->connect();
  cable.robot.motion_ms = 1000;
  after_ms(300, [this] { power_cycle(); });
  EXPECT_EQ(session->execute(exploration::Drive{0.3}), MotionResult::kInterrupted);
  EXPECT_EQ(cable.robot.moves_done.size(), 1U);
  EXPECT_FALSE(session->end());
}

}  // namespace
}  // namespace echomap::session
