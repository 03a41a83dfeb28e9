// SPDX-License-Identifier: MIT
#include "host/live_page/run_publisher.hpp"

#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/live_page/server_clock.hpp"
#include "tests/host/live_page/read_messages.hpp"

namespace echomap::live_page {
namespace {

using nlohmann::json;

RunFacts demo_facts() {
  RunFacts facts;
  facts.name = "first_map";
  facts.version = "0.1.0";
  facts.command = "demo";
  facts.live = true;
  facts.has_truth = true;
  facts.can = {"stop", "drive"};
  return facts;
}

class RunPublisherTest : public testing::Test {
 protected:
  /// The body of the motion that is told now.
  std::string motion() {
    SharedMessage told;
    history->listen([&](const SharedMessage& message) { told = message; });
    publisher.add_motion(time_s += 1.0, {{1.0, 2.0, 0.5}, {3.0, 4.0, 0.25}, std::nullopt});
    history->listen(nullptr);
    return body_of(*told);
  }
  void hear(bool has_answered, std::optional<double> range_m) {
    sensors::SonarObservation ping;
    ping.pan_rad = 0.75;
    ping.has_answered = has_answered;
    ping.range_m = range_m;
    publisher.on_sonar(ping);
  }
  json newest(MessageKind kind) const {
    const auto messages = of_kind(*history, kind);
    return messages.empty() ? json() : json_in(*messages.back());
  }

  session::RobotProfile profile = session::load_robot_profile("uno_2wd");
  std::shared_ptr<History> history = std::make_shared<History>();
  RunPublisher publisher{history, demo_facts(), profile};
  double time_s = 0.0;
};

TEST_F(RunPublisherTest, TellsAFleetAgainOnlyWhereItHasChanged) {
  TeamState team;
  team.robots = {TeamRobot{"robot0"}};
  publisher.add_team(1.0, team);
  publisher.add_team(2.0, team);
  EXPECT_EQ(of_kind(*history, MessageKind::kTeam).size(), 1U);
  team.robots.front().stops = 1;
  publisher.add_team(3.0, team);
  EXPECT_EQ(of_kind(*history, MessageKind::kTeam).size(), 2U);
  EXPECT_EQ(newest(MessageKind::kTeam)["robots"][0]["stops"], 1);
}

TEST_F(RunPublisherTest, SaysFirstWhatTheRunIs) {
  const auto messages = history->since(0);
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages.front()->kind, MessageKind::kHello);
  EXPECT_EQ(messages.front()->time_s, 0.0);
  json expected = json::parse(R"({"version": "0.1.0", "run": "0", "name": "first_map",
    "command": "demo", "live": true, "robot": "uno_2wd", "resolution_m": 0.05, "step_logits": 0.05,
    "free_below": 0.196, "occupied_above": 0.65, "can": ["stop", "drive"], "has_truth": true})");
  expected["radius_m"] = profile.body_radius_m;
  expected["sonar"] = {{"x_m", profile.geometry.sonar_x_m},
                       {"y_m", profile.geometry.sonar_y_m},
                       {"half_angle_rad", profile.beam_half_angle_rad},
                       {"max_range_m", profile.range.max_range_m}};
  EXPECT_EQ(json_in(*messages.front()), expected);
}

TEST_F(RunPublisherTest, SaysThatARobotHasNoSonar) {
  const auto other = std::make_shared<History>();
  const RunPublisher create(other, demo_facts(), session::load_robot_profile("create"));
  const json hello = json_in(*other->since(0).front());
  EXPECT_TRUE(hello.at("sonar").is_null());
  EXPECT_EQ(hello.at("robot"), "create");
}

TEST_F(RunPublisherTest, TellsMotionsByTheServersClock) {
  const double before_ms = server_clock_ms();
  const std::string body = motion();
  EXPECT_GE(f64_at(body, 0), before_ms);
  EXPECT_LE(f64_at(body, 0), server_clock_ms());
  EXPECT_EQ(f32_at(body, 8), 1.0F);
  EXPECT_EQ(f32_at(body, 36), 3.0F);
}

TEST_F(RunPublisherTest, CountsPingsAndTellsWhatTheLastOneHeard) {
  EXPECT_EQ(u32_at(motion(), 68), 0U) << "none yet";
  EXPECT_EQ(u32_at(motion(), 72), 0U);
  hear(true, 1.5);
  const std::string echo = motion();
  EXPECT_EQ(f32_at(echo, 60), 0.75F);
  EXPECT_EQ(f32_at(echo, 64), 1.5F);
  EXPECT_EQ(u32_at(echo, 68), 1U);
  EXPECT_EQ(u32_at(echo, 72), 1U);
  EXPECT_EQ(u32_at(motion(), 68), 1U) << "the same ping";
  hear(true, std::nullopt);
  EXPECT_EQ(u32_at(motion(), 68), 2U);
  EXPECT_EQ(u32_at(motion(), 72), 2U) << "silence";
  hear(false, std::nullopt);
  EXPECT_EQ(u32_at(motion(), 68), 3U);
  EXPECT_EQ(u32_at(motion(), 72), 3U) << "no answer";
}

TEST_F(RunPublisherTest, RemembersBatteryAndHazards) {
  EXPECT_FALSE(publisher.battery_v());
  publisher.on_battery({{}, 7.5});
  EXPECT_EQ(publisher.battery_v(), 7.5);
  sensors::HazardObservation hazards;
  hazards.bump_left = true;
  publisher.on_hazards(hazards);
  EXPECT_TRUE(publisher.hazards().is_touching());
}

TEST_F(RunPublisherTest, TellsAStateOnlyWhereItIsAnotherOne) {
  RunState state;
  publisher.add_state(1.0, state);
  publisher.add_state(2.0, state);
  EXPECT_EQ(of_kind(*history, MessageKind::kState).size(), 1U);
  state.stops = 1;
  publisher.add_state(3.0, state);
  const auto states = of_kind(*history, MessageKind::kState);
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states.back()->time_s, 3.0);
  EXPECT_EQ(json_in(*states.back()).at("stops"), 1);
}

TEST_F(RunPublisherTest, TellsEventsHoweverAlike) {
  publisher.add_event(1.0, {"bumped", RunEvent::Level::kInfo, "it touched something"});
  publisher.add_event(2.0, {"bumped", RunEvent::Level::kInfo, "it touched something"});
  EXPECT_EQ(of_kind(*history, MessageKind::kEvent).size(), 2U);
  EXPECT_EQ(newest(MessageKind::kEvent).at("level"), "info");
  publisher.add_event(3.0, {"a", RunEvent::Level::kError, "b", "c", "d"});
  EXPECT_EQ(newest(MessageKind::kEvent),
            json::parse(R"({"code": "a", "level": "error", "text": "b", "cause": "c",
                            "remedy": "d"})"));
  publisher.add_event(4.0, {"a", RunEvent::Level::kWarning, "b"});
  EXPECT_EQ(newest(MessageKind::kEvent).at("level"), "warning");
  EXPECT_EQ(newest(MessageKind::kEvent).at("cause"), "");
}

TEST_F(RunPublisherTest, TellsParticles) {
  publisher.add_particles(1.0, {{{1.0, 2.0, 0.5}, 1.0}});
  const auto sets = of_kind(*history, MessageKind::kParticles);
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_EQ(u32_at(body_of(*sets.front()), 0), 1U);
}

TEST_F(RunPublisherTest, ItsMapGoesIntoTheSameHistory) {
  mapping::OccupancyGrid grid;
  grid.add({0, 0}, 100);
  publisher.map().look_at(1.0, grid);
  EXPECT_EQ(of_kind(*publisher.history(), MessageKind::kTile).size(), 1U);
}

}  // namespace
}  // namespace echomap::live_page
