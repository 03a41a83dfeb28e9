// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/robot_link/link_fixture.hpp"

namespace echomap::robot_link {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// How the link comes up, what it says when it does not, and how it comes back.
class LinkRecoveryTest : public LinkFixture {
 protected:
  void flood_with_text(int duration_ms) {
    for (int i = 0; i < duration_ms / 50; ++i) {
      const std::string line = "Distance: 42 cm\r\n";
      link.receive({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()}, now());
      run_for(50);
    }
  }
};

TEST_F(LinkRecoveryTest, SaysADelimiterAndHelloFirst) {
  link.poll(now());
  const auto bytes = link.take_outgoing();
  ASSERT_FALSE(bytes.empty());
  EXPECT_EQ(bytes.front(), 0);
  robot.receive(bytes);
  EXPECT_EQ(robot.hellos, 1);
}

TEST_F(LinkRecoveryTest, RepeatsHelloEvery50MsUntilItIsAnswered) {
  to_host.is_cut = true;
  run_for(1000);
  EXPECT_EQ(robot.hellos, 20);
  to_host.is_cut = false;
  run_for(100);
  EXPECT_EQ(link.state(), LinkState::kReady);
  const int hellos = robot.hellos;
  run_for(1000);
  EXPECT_EQ(robot.hellos, hellos);
  EXPECT_THAT(listener.events, ElementsAre("ready"));
}

TEST_F(LinkRecoveryTest, IsReadyWithin300MsOfPower) {
  run_for(300);
  EXPECT_EQ(link.state(), LinkState::kReady);
  ASSERT_TRUE(link.robot());
  EXPECT_EQ(link.robot()->tick_hz, 1000);
}

TEST_F(LinkRecoveryTest, CallsAPortWithoutBytesSilent) {
  robot_has_power = false;
  run_for(1999);
  EXPECT_EQ(link.state(), LinkState::kConnecting);
  run_for(10);
  EXPECT_EQ(link.state(), LinkState::kSilent);
}

TEST_F(LinkRecoveryTest, CallsBytesThatAreNoFramesGarbageAndKeepsTheFirst) {
  robot_has_power = false;
  flood_with_text(2100);
  EXPECT_EQ(link.state(), LinkState::kGarbage);
  EXPECT_EQ(link.preview().bytes().size(), 64U);
  EXPECT_THAT(link.preview().text(), HasSubstr("|Distance: 42 cm.|"));
}

TEST_F(LinkRecoveryTest, CallsFramesWithoutAnAnswerUnheard) {
  robot.streams_before_hello = true;
  to_robot.is_cut = true;
  run_for(2100);
  EXPECT_EQ(link.state(), LinkState::kUnheard);
  EXPECT_TRUE(listener.odometry.empty());
}

TEST_F(LinkRecoveryTest, BecomesReadyOutOfAnyBadStart) {
  robot_has_power = false;
  run_for(3000);
  EXPECT_EQ(link.state(), LinkState::kSilent);
  flood_with_text(500);
  EXPECT_EQ(link.state(), LinkState::kGarbage);
  robot_has_power = true;
  run_for(100);
  EXPECT_EQ(link.state(), LinkState::kReady);
  EXPECT_TRUE(link.preview().bytes().empty());
}

TEST_F(LinkRecoveryTest, NamesBothVersionsOfAMismatchAndGoesNoFurther) {
  robot.protocol_minor = 9;
  robot.schema_digest = 0x0000BEEF;
  robot.schema = {};
  link.submit(protocol::Arm{0, 1});
  run_for(500);
  EXPECT_EQ(link.state(), LinkState::kMismatch);
  ASSERT_TRUE(link.mismatch());
  EXPECT_EQ(link.mismatch()->side_to_update(), SideToUpdate::kHost);
  EXPECT_THAT(link.mismatch()->message(), HasSubstr("0000beef"));
  EXPECT_THAT(listener.events, ElementsAre("link lost"));
  EXPECT_TRUE(robot.command_ids_received.empty());
}

TEST_F(LinkRecoveryTest, IsLostAfterASecondWithoutFramesAndComesBackWithoutAReset) {
  run_for(100);
  to_host.is_cut = true;
  run_for(950);
  EXPECT_EQ(link.state(), LinkState::kReady);
  link.submit(protocol::Stop{});
  run_for(100);
  EXPECT_EQ(link.state(), LinkState::kLost);
  EXPECT_THAT(listener.events, ElementsAre("ready", "link lost"));
  to_host.is_cut = false;
  run_for(100);
  EXPECT_EQ(link.state(), LinkState::kReady);
  EXPECT_THAT(listener.events, ElementsAre("ready", "link lost", "ready"));
}

TEST_F(LinkRecoveryTest, GivesACommandUpAfterEightTries) {
  run_for(100);
  robot.acknowledges = false;
  link.submit(protocol::Stop{});
  link.submit(protocol::Stop{});
  run_for(5000);
  EXPECT_THAT(robot.command_ids_received, ElementsAre(1, 1, 1, 1, 1, 1, 1, 1));
  EXPECT_THAT(listener.events, ElementsAre("ready", "link lost", "link lost", "ready"));
}

TEST_F(LinkRecoveryTest, AsksARobotThatWasResetUnheardAlthoughItAnswersCommands) {
  run_for(1000);
  robot.announces_boot = false;
  robot.power_on(2, protocol::kResetBrownOut);
  for (int i = 0; i < 20; ++i) {
    link.submit(protocol::MoveTicks{0, 1, 1, 100, 200});
    run_for(100);
  }
  EXPECT_EQ(link.state(), LinkState::kReady);
  EXPECT_THAT(listener.reset_causes, ElementsAre(protocol::kResetBrownOut));
  EXPECT_EQ(robot.moves_done.size(), 19U);
}

TEST_F(LinkRecoveryTest, EndsCommandsAtOnceWhereThereIsNoRobot) {
  robot_has_power = false;
  run_for(2500);
  link.submit(protocol::Stop{});
  run_for(1);
  EXPECT_THAT(listener.events, ElementsAre("link lost"));
}

/// Firmware that announces its start, and firmware of which the host must find out.
struct BootHabit {
  const char* name;
  bool announces_boot;
  bool streams_before_hello;
};

class LinkResetTest : public LinkRecoveryTest, public testing::WithParamInterface<BootHabit> {
 protected:
  void SetUp() override { behave(robot); }

  static void behave(FakeRobot& fake) {
    fake.announces_boot = GetParam().announces_boot;
    fake.streams_before_hello = GetParam().streams_before_hello;
  }
};

TEST_P(LinkResetTest, NoticesAResetBeforeAnyOfItsTelemetry) {
  run_for(5000);
  robot.acknowledges = false;
  link.submit(protocol::Stop{});
  run_for(10);
  robot.power_on(2, protocol::kResetWatchdog);
  listener.odometry.clear();
  while (listener.reset_causes.empty() && now_ms < 8000) {
    run_for(1);
  }
  EXPECT_TRUE(listener.odometry.empty() || listener.odometry.back().stamp_us > 4'900'000);
  EXPECT_LE(now_ms, 5010 + 400);
  run_for(100);
  EXPECT_THAT(listener.events, ElementsAre("ready", "robot was reset", "reset", "ready"));
  EXPECT_THAT(listener.reset_causes, ElementsAre(protocol::kResetWatchdog));
  EXPECT_LT(listener.odometry.back().stamp_us, 1'000'000U);
  EXPECT_EQ(link.statistics().resets_seen, 1U);
}

TEST_P(LinkResetTest, NeverDoesACommandTwiceThatTheRobotForgot) {
  run_for(5000);
  to_host.is_cut = true;
  link.submit(protocol::MoveTicks{0, 1, 1, 100, 200});
  run_for(20);
  EXPECT_EQ(robot.moves_done.size(), 1U);
  to_host.is_cut = false;
  robot.power_on(2);
  run_for(1500);
  EXPECT_EQ(robot.moves_done.size(), 1U);
  ASSERT_EQ(listener.results.size(), 1U);
  EXPECT_NE(listener.results[0].outcome, CommandOutcome::kAccepted);
  EXPECT_EQ(listener.events.back(), "ready");
}

TEST_P(LinkResetTest, ShakesHandsThroughAResetInTheMiddleOfTheReply) {
  constexpr std::size_t kReplyBytes =
      1 + protocol::kFrameOverhead + protocol::MessageFacts<protocol::HelloReply>::kSize;
  for (std::size_t cut_at = 1; cut_at < kReplyBytes; ++cut_at) {
    RecordingListener heard;
    RobotLink fresh(heard, 7);
    FakeRobot resetting;
    behave(resetting);
    fresh.poll(now());
    resetting.receive(fresh.take_outgoing());
    auto reply = resetting.take_outgoing();
    ASSERT_EQ(reply.size(), kReplyBytes) << "with its delimiter";
    reply.resize(cut_at);
    fresh.receive(reply, now());
    resetting.power_on(2);
    now_ms += 50;
    fresh.poll(now());
    resetting.receive(fresh.take_outgoing());
    fresh.receive(resetting.take_outgoing(), now());
    ASSERT_EQ(fresh.state(), LinkState::kReady) << cut_at;
    ASSERT_EQ(fresh.robot()->boot_id, 2) << cut_at;
  }
}

TEST_P(LinkResetTest, RecoversFromAHundredResetsAtAnyMoment) {
  run_for(1000);
  for (std::uint16_t boot = 2; boot < 102; ++boot) {
    robot.power_on(boot, protocol::kResetBrownOut);
    run_for(400 + static_cast<int>(random() % 2000));
    ASSERT_EQ(link.state(), LinkState::kReady) << boot;
    ASSERT_EQ(listener.reset_causes.size(), boot - 1U);
  }
  EXPECT_EQ(link.statistics().frames_bad, 0U);
}

INSTANTIATE_TEST_SUITE_P(Firmware,
                         LinkResetTest,
                         testing::Values(BootHabit{"Announces", true, false},
                                         BootHabit{"Shy", false, false},
                                         BootHabit{"Chatty", false, true}),
                         [](const auto& chosen) { return std::string(chosen.param.name); });

// --- another host

TEST_F(LinkRecoveryTest, WaitsForARobotThatAnotherHostHoldsAndSaysNothingButHello) {
  robot.hear_of_another(protocol::Hello{1, 3, 0, 99});
  run_for(1000);
  EXPECT_EQ(link.state(), LinkState::kBusy);
  EXPECT_EQ(link.holder(), 99);
  EXPECT_EQ(robot.pings, 0);
  EXPECT_EQ(robot.bulk_reads, 0);
  EXPECT_GE(robot.hellos, 15);
  EXPECT_EQ(robot.session(), 99);
  run_for(1800);
  EXPECT_EQ(link.state(), LinkState::kReady) << "the other one has fallen silent";
}

RobotLinkParams that_take_over() {
  RobotLinkParams params;
  params.takes_over = true;
  return params;
}

struct LinkThatTakesOver : LinkFixture {
  LinkThatTakesOver() : LinkFixture(that_take_over()) {}
};

TEST_F(LinkThatTakesOver, TakesARobotOverOnce) {
  robot.hear_of_another(protocol::Hello{1, 3, 0, 99});
  run_for(200);
  EXPECT_EQ(link.state(), LinkState::kReady);
  EXPECT_EQ(robot.session(), 0x5E55);
  robot.hear_of_another(protocol::TakeOver{99});
  run_for(1000);
  EXPECT_EQ(link.state(), LinkState::kBusy) << "it does not fight";
  EXPECT_EQ(robot.session(), 99);
}

TEST_F(LinkRecoveryTest, NoticesThatItsRobotWasTakenOver) {
  run_for(100);
  ASSERT_EQ(link.state(), LinkState::kReady);
  const auto ticket = link.submit(protocol::MoveTicks{0, 5, 5, 100, 200});
  robot.acknowledges = false;
  robot.hear_of_another(protocol::TakeOver{99});
  run_for(50);
  EXPECT_EQ(link.state(), LinkState::kBusy);
  ASSERT_EQ(listener.results.size(), 1U);
  EXPECT_EQ(listener.results[0].ticket, ticket);
  EXPECT_EQ(listener.results[0].outcome, CommandOutcome::kLinkLost);
}

TEST_F(LinkRecoveryTest, IsNotDisturbedByAHelloThatTheRobotRefuses) {
  run_for(100);
  for (int i = 0; i < 100; ++i) {
    robot.hear_of_another(protocol::Hello{1, 3, 0, 99});
    run_for(20);
    ASSERT_EQ(link.state(), LinkState::kReady);
  }
  EXPECT_EQ(robot.session(), 0x5E55);
  EXPECT_EQ(link.statistics().outages, 0U);
}

TEST_F(LinkRecoveryTest, LeavesOutWhatOlderFirmwareRepliesToOthers) {
  robot.protocol_minor = 2;
  run_for(100);
  ASSERT_EQ(link.state(), LinkState::kReady);
  robot.hear_of_another(protocol::Hello{1, 2, 0, 99});
  run_for(50);
  EXPECT_EQ(link.state(), LinkState::kReady);
}

}  // namespace
}  // namespace echomap::robot_link
