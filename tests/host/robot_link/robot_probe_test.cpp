// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_probe.hpp"

#include <string>

#include <gtest/gtest.h>

#include "tests/host/robot_link/link_fixture.hpp"

namespace echomap::robot_link {
namespace {

TEST(RobotProbe, KnowsARobotByItsAnswer) {
  FakeRobot robot;
  robot.announces_boot = false;
  robot.power_on(0x1234);
  RobotProbe probe(7);
  robot.receive(probe.hello());
  EXPECT_EQ(robot.hellos, 1);
  EXPECT_FALSE(probe.robot());
  probe.receive(robot.take_outgoing());
  ASSERT_TRUE(probe.robot());
  EXPECT_EQ(probe.robot()->boot_id, 0x1234);
  EXPECT_EQ(probe.robot()->session, 7);
}

class ProbedRobot : public LinkFixture {};

TEST_F(ProbedRobot, MissesNoFrameWhenTheLinkTakesOver) {
  robot.receive(RobotProbe(0x5E55).hello());
  run_for(1000);
  EXPECT_EQ(link.state(), LinkState::kReady);
  ASSERT_FALSE(listener.statuses.empty());
  EXPECT_EQ(link.statistics().robot_frames_lost, 0U);
}

TEST(RobotProbe, KnowsARobotThatJustStartedByItsOwnWord) {
  FakeRobot robot;
  robot.power_on(5);
  RobotProbe probe(7);
  probe.receive(robot.take_outgoing());
  EXPECT_TRUE(probe.robot());
}

TEST(RobotProbe, KeepsWhatElseCame) {
  RobotProbe probe(7);
  EXPECT_TRUE(probe.preview().bytes().empty());
  const std::string modem = "ERROR\r\n";
  probe.receive(std::span(reinterpret_cast<const std::uint8_t*>(modem.data()), modem.size()));
  EXPECT_FALSE(probe.robot());
  EXPECT_NE(probe.preview().text().find("ERROR"), std::string::npos);
}

}  // namespace
}  // namespace echomap::robot_link
