// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/robot_link/link_fixture.hpp"
#include "tests/host/robot_link/other_messages.hpp"

namespace echomap::robot_link {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A host and firmware that were built from other messages.
class LinkCompatibility : public LinkFixture {
 protected:
  template <class List>
  void build_firmware_from(std::uint8_t protocol_minor) {
    robot.schema = description_of<List>();
    robot.schema_digest = protocol::DigestOf<List>::kValue;
    robot.protocol_minor = protocol_minor;
  }
};

TEST_F(LinkCompatibility, DrivesAnOlderRobotThatHasAllThatIsNeeded) {
  build_firmware_from<other_messages::Older>(0);
  link.submit(protocol::Arm{0, 1});
  run_for(500);
  EXPECT_EQ(link.state(), LinkState::kReady);
  EXPECT_THAT(listener.events, ElementsAre("ready", "accepted"));
  ASSERT_TRUE(link.difference());
  EXPECT_THAT(link.difference()->missing_on_robot(), testing::Contains("Gyro"));
  EXPECT_GT(listener.odometry.size(), 10U);
}

TEST_F(LinkCompatibility, CountsTheMessagesThatOnlyANewerRobotUnderstands) {
  build_firmware_from<other_messages::Newer>(9);
  run_for(500);
  ASSERT_EQ(link.state(), LinkState::kReady);
  const auto before = link.statistics();
  for (std::uint32_t i = 0; i < 20; ++i) {
    robot.send(Compass{i, 5});
    run_for(10);
  }
  run_for(100);
  EXPECT_EQ(link.statistics().frames_foreign, 20U);
  EXPECT_EQ(link.statistics().frames_bad, before.frames_bad);
  EXPECT_EQ(link.statistics().frames_lost, before.frames_lost);
}

TEST_F(LinkCompatibility, WithholdsWhatTheRobotWouldReadOtherwise) {
  build_firmware_from<other_messages::Older>(0);
  run_for(500);
  link.send(protocol::DriveSetpoint{1, 1, 200}, now());
  run_for(100);
  EXPECT_TRUE(robot.setpoints.empty());
  EXPECT_EQ(link.statistics().frames_withheld, 1U);
}

TEST_F(LinkCompatibility, EndsACommandThatTheRobotDoesNotHave) {
  build_firmware_from<other_messages::Foreign>(0);
  RecordingListener hears;
  RobotLinkParams params;
  params.needed_messages = {};
  RobotLink undemanding(hears, 7, params);
  undemanding.submit(protocol::Stop{});
  for (; now_ms < 500; ++now_ms) {
    robot.advance_1ms();
    undemanding.receive(robot.take_outgoing(), now());
    undemanding.poll(now());
    robot.receive(undemanding.take_outgoing());
  }
  EXPECT_THAT(hears.events, ElementsAre("ready", "not understood by the firmware"));
  EXPECT_TRUE(robot.command_ids_received.empty());
}

TEST_F(LinkCompatibility, RefusesANewerRobotThatLacksWhatIsNeeded) {
  build_firmware_from<other_messages::Foreign>(9);
  run_for(500);
  EXPECT_EQ(link.state(), LinkState::kMismatch);
  const std::string message = link.mismatch()->message();
  EXPECT_THAT(message, HasSubstr("protocol 1.9"));
  EXPECT_THAT(message, HasSubstr("other fields in Odometry; the robot lacks Ack"));
  EXPECT_THAT(message, HasSubstr("git pull"));
}

TEST_F(LinkCompatibility, AsksAgainForPiecesThatAreLost) {
  build_firmware_from<other_messages::Newer>(9);
  to_robot.faults = to_host.faults = {.lost = 0.2};
  run_for(5000);
  EXPECT_EQ(link.state(), LinkState::kReady);
}

TEST_F(LinkCompatibility, DescribesOnceHoweverOftenTheLinkComesBack) {
  build_firmware_from<other_messages::Newer>(9);
  run_for(500);
  const int reads = robot.bulk_reads;
  EXPECT_GT(reads, 10);
  to_host.is_cut = true;
  run_for(1500);
  to_host.is_cut = false;
  robot.power_on(2);
  run_for(500);
  EXPECT_EQ(link.state(), LinkState::kReady);
  EXPECT_EQ(robot.bulk_reads, reads);
}

TEST_F(LinkCompatibility, RefusesARobotThatDoesNotTellItsMessages) {
  build_firmware_from<other_messages::Newer>(9);
  robot.answers_bulk_reads = false;
  robot.streams_before_hello = true;
  run_for(6000);
  EXPECT_EQ(link.state(), LinkState::kMismatch);
}

TEST_F(LinkCompatibility, ReadsTheConfigurationOfAReadyRobot) {
  run_for(500);
  robot.configuration.pan.max_cdeg = 1234;
  link.read(protocol::BulkContent::kConfiguration);
  run_for(200);
  ASSERT_EQ(listener.bulk.size(), 1U);
  EXPECT_EQ(listener.bulk[0].status, BulkStatus::kWhole);
  EXPECT_EQ(listener.bulk[0].bytes.size(), std::size_t{protocol::ConfigurationBytes::kSize});
}

TEST_F(LinkCompatibility, EndsAReadingWhenTheRobotIsReset) {
  run_for(500);
  robot.answers_bulk_reads = false;
  link.read(protocol::BulkContent::kConfiguration);
  run_for(20);
  robot.power_on(2);
  run_for(500);
  ASSERT_EQ(listener.bulk.size(), 1U);
  EXPECT_EQ(listener.bulk[0].status, BulkStatus::kNoAnswer);
}

}  // namespace
}  // namespace echomap::robot_link
