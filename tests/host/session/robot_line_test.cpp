// SPDX-License-Identifier: MIT
#include "host/session/robot_line.hpp"

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include "host/console/exit_code.hpp"
#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::session {
namespace {

using exploration::MotionResult;

/// What a session makes of its line.
class RobotLineTest : public SessionOnACable {};

TEST_F(RobotLineTest, EndsForSafetyWhenTheRobotIsLifted) {
  session->connect();
  cable.robot.motion_ms = 3000;
  after_ms(300, [this] { cable.robot.hazards = protocol::kHazardWheelDrop; });
  session->execute(exploration::Drive{0.2});
  EXPECT_EQ(session->end(), SessionEnd::kSafetyStop);
  EXPECT_NE(session->end_reason().find("lifted"), std::string::npos);
  EXPECT_EQ(pipeline.snapshot().times_lifted, 1U);
  EXPECT_EQ(exit_code_of(*session->end()), console::ExitCode::kSafetyStop);
}

TEST_F(RobotLineTest, WaitsForARobotThatMayBeLiftedUntilItStands) {
  may_be_lifted = true;
  session = new_session(false);
  session->connect();
  cable.robot.motion_ms = 3000;
  time::HostTime placed;
  after_ms(300, [&] {
    cable.robot.hazards = protocol::kHazardWheelDrop;
    cable.robot.armed = false;
    after_ms(5000, [&] {
      cable.robot.hazards = 0;
      placed = session->now();
    });
  });
  session->execute(exploration::Drive{0.1});
  cable.robot.motion_ms = 100;
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kReached);
  EXPECT_GT(session->now(), placed);
  EXPECT_GT(placed, time::HostTime());
  EXPECT_TRUE(cable.robot.armed);
  EXPECT_FALSE(session->end());
}

TEST_F(RobotLineTest, EndsWhenARobotThatMayBeLiftedIsNotPutDownWithinFiveMinutes) {
  may_be_lifted = true;
  session = new_session(false);
  session->connect();
  cable.robot.motion_ms = 3000;
  time::HostTime lifted;
  after_ms(300, [&] {
    cable.robot.hazards = protocol::kHazardWheelDrop;
    cable.robot.armed = false;
    lifted = session->now();
  });
  session->execute(exploration::Drive{0.1});
  EXPECT_FALSE(session->end());
  session->execute(exploration::Drive{0.2});
  EXPECT_EQ(session->end(), SessionEnd::kSafetyStop);
  EXPECT_NE(session->end_reason().find("not put down within 5 minutes\n  next: put it down"),
            std::string::npos)
      << session->end_reason();
  EXPECT_GT(session->now(), lifted + std::chrono::minutes(5));
  EXPECT_LT(session->now(), lifted + std::chrono::minutes(5) + std::chrono::seconds(1));
}

TEST_F(RobotLineTest, WaitsForEveryLiftAnew) {
  may_be_lifted = true;
  session = new_session(false);
  session->connect();
  for (int lift = 0; lift < 2; ++lift) {
    cable.robot.motion_ms = 3000;
    after_ms(300, [&] {
      cable.robot.hazards = protocol::kHazardWheelDrop;
      cable.robot.armed = false;
      after_ms(4 * 60'000, [&] { cable.robot.hazards = 0; });
    });
    session->execute(exploration::Drive{0.1});
    cable.robot.motion_ms = 100;
    EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kReached) << lift;
  }
  EXPECT_FALSE(session->end());
}

TEST_F(RobotLineTest, KeepsTheStampOfOdometryApartFromThatOfOtherTelemetry) {
  session->connect();
  protocol::Status status{};
  status.stamp_us = cable.robot.stamp_us() + 15'000;
  cable.robot.send(status);
  session->wait_until([] { return false; }, std::chrono::milliseconds(5));
  EXPECT_EQ(session->link().newest_stamp_us(), status.stamp_us);
  ASSERT_TRUE(session->odometry_stamp_us());
  EXPECT_LT(*session->odometry_stamp_us(), status.stamp_us);
  EXPECT_GE(*session->odometry_stamp_us() + 35'000, status.stamp_us);
}

TEST_F(RobotLineTest, TakesLongSilenceForADeadSonarWhereTheFirmwareIsTooOldToTell) {
  for (const bool is_older : {true, false}) {
    cable.robot.protocol_minor = is_older ? 1 : protocol::kNoSonarSinceMinor;
    session = new_session(false);
    session->connect();
    pipeline.begin_scan();
    for (int i = 0; i < 61; ++i) {
      cable.robot.send(protocol::Echo{cable.robot.stamp_us(), 0, protocol::kNoEcho, 0, 0});
      session->execute(exploration::Turn{0.01});
    }
    pipeline.end_scan();
    const mapping::Scan scan = *pipeline.snapshot().last_scan;
    ASSERT_EQ(scan.size(), 61U);
    EXPECT_EQ(scan.back().has_answered, !is_older);
  }
}

TEST_F(RobotLineTest, WaitsForALinkThatIsAway) {
  session->connect();
  cable.robot.motion_ms = 500;
  after_ms(100, [this] {
    cable.plugged = false;
    after_ms(2500, [this] { cable.plugged = true; });
  });
  session->execute(exploration::Drive{0.1});
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kReached);
  EXPECT_FALSE(session->end());
}

TEST_F(RobotLineTest, SaysInALineEachThatTheRobotIsAwayBackAndReset) {
  std::ostringstream said;
  const auto before = spdlog::default_logger();
  spdlog::set_default_logger(std::make_shared<spdlog::logger>(
      "test", std::make_shared<spdlog::sinks::ostream_sink_st>(said)));
  session->connect();
  after_ms(100, [this] {
    cable.plugged = false;
    cable.robot.power_on(2, protocol::kResetBrownOut);
    after_ms(2500, [this] { cable.plugged = true; });
  });
  session->execute(exploration::Drive{0.1});
  session->execute(exploration::Drive{0.1});
  spdlog::set_default_logger(before);
  const std::string text = said.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
  EXPECT_NE(text.find("cable is disconnected: the robot stopped sending"), std::string::npos)
      << text;
  EXPECT_NE(text.find("cable reconnected after"), std::string::npos) << text;
  EXPECT_NE(text.find("the robot was reset (brown-out)"), std::string::npos) << text;
}

TEST_F(RobotLineTest, EndsWhenTheRobotStaysAway) {
  session->connect();
  cable.plugged = false;
  session->execute(exploration::Drive{0.1});
  session->execute(exploration::Drive{0.1});
  EXPECT_EQ(session->end(), SessionEnd::kLinkLost);
}

TEST_F(RobotLineTest, EndsWhenABoardIsResetThatTurnsItsSonarByAStepper) {
  profile.configuration.pan.kind = static_cast<std::uint8_t>(protocol::PanKind::kStepper);
  session = new_session(false);
  session->connect();
  ASSERT_FALSE(session->end()) << "it comes up from a reset";
  cable.robot.motion_ms = 3000;
  after_ms(300, [this] { power_cycle(); });
  session->execute(exploration::Drive{0.2});
  EXPECT_EQ(session->end(), SessionEnd::kSafetyStop);
  EXPECT_NE(session->end_reason().find("the direction of the sonar"), std::string::npos);
}

TEST_F(RobotLineTest, EndsWhenTheRobotIsResetAndNeverComesBack) {
  session->connect();
  after_ms(50, [this] {
    power_cycle();
    after_ms(5, [this] { cable.powered = false; });
  });
  session->execute(exploration::Drive{0.1});
  session->execute(exploration::Drive{0.1});
  EXPECT_EQ(session->end(), SessionEnd::kLinkLost);
}

TEST_F(RobotLineTest, EndsAtOnceWhenThePortIsClosed) {
  session->connect();
  after_ms(50, [this] { cable.status = transport::StreamStatus::kClosed; });
  session->execute(exploration::Drive{0.1});
  EXPECT_EQ(session->end(), SessionEnd::kLinkLost);
  EXPECT_TRUE(session->end_reason().starts_with("lost cable: pulled out\n  next: "));
}

/// A simulated robot that is gone: its time stands still.
TEST_F(RobotLineTest, DisarmsNoLongerThanTimePasses) {
  session->connect();
  cable.robot.acknowledges = false;
  bool heard = false;
  cable.robot.on_command = [&](std::string_view name) {
    heard = heard || name == "Arm";
    cable.time_passes = false;
  };
  session.reset();
  EXPECT_TRUE(heard);
}

}  // namespace
}  // namespace echomap::session
