// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_link.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/robot_link/link_fixture.hpp"

namespace echomap::robot_link {
namespace {

using testing::ElementsAre;

class RobotLinkTest : public LinkFixture {};

protocol::MoveTicks move(std::int32_t left_ticks) { return {0, left_ticks, 0, 100, 200}; }

TEST_F(RobotLinkTest, DeliversTelemetryInOrder) {
  run_for(1000);
  ASSERT_GT(listener.odometry.size(), 45U);
  EXPECT_TRUE(std::is_sorted(listener.odometry.begin(),
                             listener.odometry.end(),
                             [](const auto& a, const auto& b) { return a.stamp_us < b.stamp_us; }));
  robot.send(protocol::Echo{robot.stamp_us(), -4500, 1234, 5, 6});
  run_for(5);
  ASSERT_EQ(listener.echoes.size(), 1U);
  EXPECT_EQ(listener.echoes[0].pan_cdeg, -4500);
  EXPECT_EQ(listener.echoes[0].flight_us, 1234);
}

TEST_F(RobotLinkTest, TakesFromTheGreetingWhetherTheBoardSeesEncoderErrors) {
  run_for(100);
  EXPECT_EQ(link.statistics().robot_encoder_errors, 0U);
  robot.capabilities = protocol::kCapabilityBlindEncoders;
  robot.power_on(2);
  run_for(500);
  EXPECT_EQ(link.statistics().robot_encoder_errors, std::nullopt);
}

TEST_F(RobotLinkTest, HearsTheSameHoweverTheBytesAreCut) {
  run_for(100);
  std::vector<std::uint8_t> bytes;
  for (std::uint32_t i = 0; i < 500; ++i) {
    robot.send(protocol::Odometry{robot.stamp_us() + i, static_cast<std::int16_t>(i), 0, 0});
  }
  bytes = robot.take_outgoing();
  listener.odometry.clear();
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t count = std::min<std::size_t>(random() % 40, bytes.size() - at);
    link.receive(std::span(bytes).subspan(at, count), now());
    at += count;
  }
  ASSERT_EQ(listener.odometry.size(), 500U);
  EXPECT_EQ(listener.odometry.back().left_ticks, 499);
}

TEST_F(RobotLinkTest, LosesOneFrameOnlyToACutInItsMiddle) {
  run_for(110);
  listener.odometry.clear();
  for (std::int16_t i = 0; i < 5; ++i) {
    robot.send(protocol::Odometry{robot.stamp_us(), i, 0, 0});
    std::vector<std::uint8_t> frame = robot.take_outgoing();
    if (i == 2) {
      frame.erase(frame.begin() + 4, frame.end() - 1);
    }
    link.receive(frame, now());
  }
  ASSERT_EQ(listener.odometry.size(), 4U);
  EXPECT_EQ(listener.odometry[2].left_ticks, 3);
  EXPECT_EQ(link.statistics().frames_bad, 1U);
  EXPECT_EQ(link.statistics().frames_lost, 1U);
}

TEST_F(RobotLinkTest, TellsTheRobotsAnswerToACommand) {
  run_for(100);
  using protocol::CommandStatus;
  const std::vector<std::pair<std::uint8_t, std::string>> answers = {
      {0, "accepted"},
      {1, "disarmed"},
      {2, "busy"},
      {3, "out of range"},
      {4, "blocked by a contact, a cliff or a hanging wheel"},
      {77, "refused"}};
  for (const auto& [status, name] : answers) {
    listener.events.clear();
    robot.answer = static_cast<CommandStatus>(status);
    const CommandTicket ticket = link.submit(protocol::Arm{0, 1});
    run_for(20);
    ASSERT_FALSE(listener.events.empty());
    EXPECT_EQ(listener.events.front(), name);
    EXPECT_EQ(listener.results.back().ticket, ticket);
    EXPECT_EQ(listener.results.back().command_id, robot.command_ids_received.back());
  }
}

TEST_F(RobotLinkTest, HoldsCommandsBackUntilTheRobotAnswersHello) {
  link.submit(protocol::Arm{0, 1});
  robot_has_power = false;
  run_for(500);
  EXPECT_TRUE(listener.events.empty());
  robot_has_power = true;
  run_for(100);
  EXPECT_THAT(listener.events, ElementsAre("ready", "accepted"));
  EXPECT_EQ(robot.command_ids_received.size(), 1U);
}

TEST_F(RobotLinkTest, LetsAHandlerSubmitTheNextCommand) {
  struct Chain : RecordingListener {
    void on_command_done(const CommandResult& result) override {
      RecordingListener::on_command_done(result);
      if (results.size() < 5) {
        link->submit(protocol::Stop{});
      }
    }
    RobotLink* link = nullptr;
  };
  Chain chain;
  RobotLink chained(chain, 1);
  chain.link = &chained;
  chained.submit(protocol::Stop{});
  for (int i = 0; i < 50; ++i) {
    chained.poll(now());
    robot.receive(chained.take_outgoing());
    chained.receive(robot.take_outgoing(), now());
  }
  EXPECT_EQ(chain.results.size(), 5U);
}

TEST_F(RobotLinkTest, DoesTenThousandCommandsExactlyOnceAtFivePercentLossEachWay) {
  run_for(100);
  to_robot.faults = {.lost = 0.03, .damaged = 0.02, .duplicated = 0.01};
  to_host.faults = {.lost = 0.03, .damaged = 0.02, .duplicated = 0.01};
  constexpr std::int32_t kCommands = 10'000;
  for (std::int32_t i = 0; i < kCommands; ++i) {
    link.submit(move(i));
  }
  while (listener.results.size() < kCommands && now_ms < 1'000'000) {
    run_for(100);
  }
  ASSERT_EQ(listener.results.size(), static_cast<std::size_t>(kCommands));
  EXPECT_TRUE(std::all_of(listener.results.begin(), listener.results.end(), [](const auto& result) {
    return result.outcome == CommandOutcome::kAccepted;
  }));
  std::vector<std::int32_t> each_once(kCommands);
  std::iota(each_once.begin(), each_once.end(), 0);
  EXPECT_EQ(robot.moves_done, each_once);
  EXPECT_GT(link.statistics().commands_resent, 500U);
  EXPECT_GT(robot.command_ids_received.size(), robot.moves_done.size());
  RecordProperty("resent", static_cast<int>(link.statistics().commands_resent));
  RecordProperty("simulated_ms", now_ms);
}

TEST_F(RobotLinkTest, NeverDoesACommandTwiceOnALineThatLosesHalf) {
  run_for(100);
  to_robot.faults = to_host.faults = {.lost = 0.3, .damaged = 0.2};
  std::int32_t submitted = 0;
  while (now_ms < 200'000) {
    link.submit(move(submitted++));
    run_for(100);
  }
  std::multiset<std::int32_t> done(robot.moves_done.begin(), robot.moves_done.end());
  for (const CommandResult& result : listener.results) {
    const auto index = static_cast<std::int32_t>(result.ticket) - 1;
    const std::size_t times = done.count(index);
    ASSERT_LE(times, 1U) << index;
    if (result.outcome == CommandOutcome::kAccepted) {
      ASSERT_EQ(times, 1U) << index;
    }
  }
  EXPECT_GT(robot.moves_done.size(), 100U);
}

TEST_F(RobotLinkTest, KeepsMotionAliveEvery50MsWhileItIsOn) {
  run_for(100);
  EXPECT_TRUE(robot.keep_alives.empty());
  link.keep_alive(true);
  run_for(1000);
  EXPECT_GE(robot.keep_alives.size(), 19U);
  EXPECT_LE(robot.keep_alives.size(), 20U);
  EXPECT_EQ(robot.keep_alives.front().time_to_live_ms, 200);
  link.keep_alive(false);
  run_for(10);
  robot.keep_alives.clear();
  run_for(1000);
  EXPECT_TRUE(robot.keep_alives.empty());
}

TEST_F(RobotLinkTest, SendsASetpointOnceAndOnlyToAReadyRobot) {
  link.send(protocol::DriveSetpoint{1, 2, 200}, now());
  run_for(100);
  EXPECT_TRUE(robot.setpoints.empty());
  link.send(protocol::DriveSetpoint{30, -40, 200}, now());
  run_for(500);
  ASSERT_EQ(robot.setpoints.size(), 1U);
  EXPECT_EQ(robot.setpoints[0].right_ticks_per_s, -40);
}

TEST_F(RobotLinkTest, CountsWhatWasLostBothWays) {
  run_for(100);
  to_host.faults = to_robot.faults = {.lost = 0.05, .damaged = 0.05};
  link.keep_alive(true);
  run_for(60'000);
  to_host.faults = to_robot.faults = {};
  run_for(500);
  const LinkStatistics statistics = link.statistics();
  EXPECT_GT(statistics.frames_received, 2500U);
  EXPECT_EQ(statistics.frames_lost, static_cast<std::uint64_t>(to_host.frames_harmed));
  EXPECT_EQ(statistics.robot_frames_lost, static_cast<std::uint64_t>(to_robot.frames_harmed));
  EXPECT_GT(statistics.frames_bad, 50U);
  EXPECT_GT(statistics.robot_frames_bad, 20U);
}

TEST_F(RobotLinkTest, MeasuresTheRoundTripOfTheCable) {
  run_for(100);
  EXPECT_FALSE(link.statistics().round_trip);
  for (int i = 0; i < 20; ++i) {
    link.submit(protocol::Stop{});
    run_for(50);
  }
  ASSERT_TRUE(link.statistics().round_trip);
  EXPECT_GE(link.statistics().round_trip->count(), 4'000);
  EXPECT_LE(link.statistics().round_trip->count(), 6'000);
}

TEST(RobotLink, RefusesTheSessionThatMeansNone) {
  RobotLinkListener listener;
  EXPECT_THROW(RobotLink(listener, 0), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::robot_link
