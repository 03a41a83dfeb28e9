// SPDX-License-Identifier: MIT
#include "host/fleet/relays.hpp"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/host/fleet/fleet_of_robots.hpp"

namespace echomap::fleet {
namespace {

/// r2, which has received a submap of r3 and knows r1.
class RelaysTest : public testing::Test {
 protected:
  RelaysTest() {
    std::mt19937 random(1);
    submap_ = say("r3", fleet_messages::to_message(random_submap(random, 0), 0).value(), 0.0);
  }
  std::string say(const std::string& robot, const fleet_messages::MessageBody& body, double now_s) {
    fleet_messages::FleetMessage message;
    message.sender = {robot, 1, ++counter_};
    message.body = body;
    const std::string payload = fleet_messages::encode(message).value();
    knowledge_.take(
        {fleet_messages::format_topic(fleet_messages::topic_of("hall", message, payload)),
         payload,
         false},
        now_s);
    return payload;
  }
  void update(double now_s) { relays_.update(knowledge_, publications_, now_s); }

  FleetKnowledge knowledge_{"hall", "r2", 16.0};
  Publications publications_{FleetOfRobots::params_of("r2")};
  Relays relays_{FleetOfRobots::params_of("r2")};
  std::uint32_t counter_ = 0;
  std::string submap_;
};

TEST_F(RelaysTest, RelayWhatIsRequestedOfARobotThatIsGone) {
  fleet_messages::AskMessage request{"r3", 0, {fleet_messages::content_hash(submap_)}};
  relays_.note({"late", request}, knowledge_, 20.0);
  update(20.0);
  EXPECT_EQ(relays_.count(), 1U);
  EXPECT_EQ(publications_.waiting(), 1U);
  update(21.0);
  EXPECT_EQ(publications_.waiting(), 1U) << "once";
}

TEST_F(RelaysTest, LeaveAliveRobotsToThemselves) {
  fleet_messages::AskMessage request{"r3", 0, {fleet_messages::content_hash(submap_)}};
  relays_.note({"late", request}, knowledge_, 5.0);
  update(5.0);
  EXPECT_EQ(relays_.count(), 0U);
}

TEST_F(RelaysTest, WaitForThoseThatComeBefore) {
  say("r1", fleet_messages::PresenceMessage{}, 19.0);
  fleet_messages::AskMessage request{"r3", 0, {fleet_messages::content_hash(submap_)}};
  relays_.note({"late", request}, knowledge_, 20.0);
  update(22.0);
  EXPECT_EQ(relays_.count(), 0U) << "r1 may have it";
  update(24.0);
  EXPECT_EQ(relays_.count(), 1U);
}

TEST_F(RelaysTest, PassOnWhatTheBrokerHasLost) {
  relays_.on_connected(30.0);
  update(45.0);
  EXPECT_EQ(relays_.count(), 0U) << "its author may be here";
  update(47.0);
  EXPECT_EQ(relays_.count(), 1U);
}

TEST_F(RelaysTest, TakeBackWhatAnAuthorPublishesItself) {
  relays_.on_connected(30.0);
  update(47.0);
  say("r3", fleet_messages::PresenceMessage{}, 50.0);
  update(50.0);
  EXPECT_EQ(publications_.waiting(), 1U) << "to be withdrawn";
}

}  // namespace
}  // namespace echomap::fleet
