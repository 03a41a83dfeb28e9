// SPDX-License-Identifier: MIT
#include "host/session/connect_failure.hpp"

#include <gmock/gmock.h>

#include "host/console/exit_code.hpp"
#include "tests/host/robot_link/link_fixture.hpp"

namespace echomap::session {
namespace {

using testing::HasSubstr;

class ConnectFailure : public robot_link::LinkFixture {};

TEST_F(ConnectFailure, SaysWhatToDoOfASilentPort) {
  robot_has_power = false;
  run_for(3000);
  EXPECT_EQ(connect_failure(link), console::ExitCode::kNoRobot);
  EXPECT_THAT(reason_of_connect_failure(link, "/dev/x"), HasSubstr("./run flash --port /dev/x"));
}

TEST_F(ConnectFailure, ShowsWhatCameInsteadOfFrames) {
  robot_has_power = false;
  for (int i = 0; i < 60; ++i) {
    const std::string text = "Hello, I print labels\n";
    link.receive({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, now());
    run_for(50);
  }
  EXPECT_THAT(reason_of_connect_failure(link, "p"), HasSubstr("Hello, I print"));
}

TEST_F(ConnectFailure, NamesTheWireOfARobotThatDoesNotHear) {
  robot.streams_before_hello = true;
  to_robot.is_cut = true;
  run_for(3000);
  EXPECT_THAT(reason_of_connect_failure(link, "p"), HasSubstr("RX pin"));
}

TEST_F(ConnectFailure, NamesTheSessionThatHoldsTheRobotAndHowToTakeItOver) {
  robot.hear_of_another(protocol::Hello{1, 3, 0, 0xBEE});
  run_for(500);
  EXPECT_EQ(connect_failure(link), console::ExitCode::kNoRobot);
  EXPECT_THAT(reason_of_connect_failure(link, "/dev/x"),
              testing::AllOf(HasSubstr("another program holds the robot on /dev/x (session 0bee)"),
                             HasSubstr("--take-over")));
  EXPECT_THAT(reason_of_take_over(link, "/dev/x"), HasSubstr("(session 0bee)\n  next: "));
}

TEST_F(ConnectFailure, NamesBothVersionsOfAMismatch) {
  robot.schema_digest = 0xBEEF;
  robot.schema = {};
  run_for(500);
  EXPECT_EQ(connect_failure(link), console::ExitCode::kFirmwareMismatch);
  EXPECT_THAT(reason_of_connect_failure(link, "p"), HasSubstr("0000beef"));
}

TEST_F(ConnectFailure, DoesNotCallARobotSilentThatHasAnswered) {
  run_for(100);
  robot.power_on(2);
  while (link.state() == robot_link::LinkState::kReady) {
    run_for(1);
  }
  EXPECT_THAT(reason_of_connect_failure(link, "p"), HasSubstr("resets again and again"));
  run_for(100);
  to_host.is_cut = true;
  run_for(1500);
  EXPECT_THAT(reason_of_connect_failure(link, "p"), HasSubstr("answered once and then stopped"));
}

TEST_F(ConnectFailure, SaysThatARobotDidNotDescribeItself) {
  robot.schema_digest = 0xBEEF;
  robot.answers_bulk_reads = false;
  run_for(100);
  EXPECT_THAT(reason_of_connect_failure(link, "p"), HasSubstr("./run flash --port p"));
  EXPECT_THAT(reason_of_connect_failure(link, "p"), HasSubstr("other messages"));
}

TEST_F(ConnectFailure, TellsAResetByItsCauseAndByTheRobotsClock) {
  robot_has_power = false;
  run_for(1000);
  EXPECT_FALSE(was_reset_since(time::HostTime{}, link));
  robot_has_power = true;
  robot.power_on(2, protocol::kResetExternal);
  run_for(1000);
  EXPECT_TRUE(was_reset_since(time::HostTime{}, link));
  EXPECT_FALSE(was_reset_since(now(), link));
  robot.power_on(3, protocol::kResetPowerOn);
  run_for(1000);
  EXPECT_FALSE(was_reset_since(time::HostTime{}, link));
}

}  // namespace
}  // namespace echomap::session
