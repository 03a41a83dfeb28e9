// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/running_broker.hpp"

// Whether somebody may write is judged by what another one gets: a broker may acknowledge what it
// denies.
namespace echomap::broker {
namespace {

using mqtt::Connection;
using mqtt::ConnectionParams;
using mqtt::Delivery;
using mqtt::Message;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using tests::Client;

/// One topic of each kind below a robot's name.
const std::vector<std::string> topic_kinds{"presence",
                                           "pose",
                                           "submap/6f1c",
                                           "graph/0",
                                           "manifest/0",
                                           "relay/6f1c",
                                           "claim",
                                           "source/92ab",
                                           "clock",
                                           "alignment",
                                           "ask"};

/// robot1 owns what is written, robot2 is another one, watcher a third that hears the fleet.
class RightsTest : public testing::Test {
 protected:
  static std::string topic(const std::string& rest) { return "echomap/1/lab/" + rest; }

  /// Each kind below robot1, of both deliveries, with the role as payload.
  static void publish_every_kind(Connection& role, const std::string& name) {
    for (const std::string& kind : topic_kinds) {
      for (const Delivery delivery : {Delivery::kAtMostOnce, Delivery::kAtLeastOnce}) {
        role.publish(topic("robot1/" + kind), name, delivery, false);
      }
    }
  }

  /// Payloads by topic that come until `end` does.
  static std::map<std::string, std::multiset<std::string>> heard_by(Client& client,
                                                                    const std::string& end) {
    std::map<std::string, std::multiset<std::string>> heard;
    for (const Message& message : client.heard_until(end)) {
      heard[message.topic].insert(message.payload);
    }
    EXPECT_FALSE(heard.empty());
    return heard;
  }

  /// The last message of a role, which it may write.
  static void publish_end(Client& role, const std::string& name) {
    role->publish(topic(name + "/clock"), "end of " + name, Delivery::kAtLeastOnce, false);
    EXPECT_TRUE(role.is_acknowledged());
  }

  Client member(const std::string& name, const std::string& filter = "") const {
    return Client(broker_.params(name), filter);
  }

  tests::RunningBroker broker_{tests::broker_settings({"robot1", "robot2", "watcher", "hub"})};
};

TEST_F(RightsTest, OfEveryKindOnlyTheOwnersIsDelivered) {
  Client watcher = member("watcher", topic("#"));
  for (const std::string name : {"robot2", "hub"}) {
    Client role = member(name);
    publish_every_kind(*role, name);
    publish_end(role, name);
    EXPECT_EQ(role->statistics().refused, topic_kinds.size()) << name;
    EXPECT_EQ(role->last_refused()->reason, mqtt::Reason::kNotAuthorized);
  }
  Client owner = member("robot1");
  publish_every_kind(*owner, "robot1");
  publish_end(owner, "robot1");
  EXPECT_EQ(owner->statistics().refused, 0U);

  const auto heard = heard_by(watcher, "end of robot1");
  for (const std::string& kind : topic_kinds) {
    auto payloads = heard.at(topic("robot1/" + kind));
    payloads.erase("end of robot1");
    EXPECT_THAT(payloads, ElementsAre("robot1", "robot1")) << kind;
  }
}

TEST_F(RightsTest, OfStrangersNothingIsDelivered) {
  Client watcher = member("watcher", topic("#"));
  ConnectionParams nobody = broker_.params("robot1");
  nobody.user.clear();
  ConnectionParams guesser = broker_.params("robot1");
  guesser.password = "12345678";
  ConnectionParams unknown = broker_.params("robot1");
  unknown.user = "robot9";
  for (const ConnectionParams& params : {nobody, guesser, unknown}) {
    Connection stranger(params);
    stranger.subscribe("#");
    publish_every_kind(stranger, "stranger");
    std::vector<Message> heard;
    EXPECT_TRUE(tests::serve_until(
        stranger, heard, [&] { return stranger.statistics().failed_attempts == 2; }));
    EXPECT_EQ(stranger.reason(), mqtt::Reason::kWrongPassword);
    EXPECT_EQ(stranger.statistics().published, 0U);
    EXPECT_THAT(heard, IsEmpty());
  }
  Client owner = member("robot1");
  publish_end(owner, "robot1");
  EXPECT_EQ(heard_by(watcher, "end of robot1").size(), 1U);
}

TEST_F(RightsTest, EveryMemberReadsTheFleet) {
  std::map<std::string, Client> readers;
  for (const std::string name : {"robot1", "robot2", "hub"}) {
    readers.emplace(name, member(name, "#"));
  }
  publish_every_kind(*readers.at("robot1"), "robot1");
  publish_end(readers.at("robot1"), "robot1");
  for (auto& [name, reader] : readers) {
    const auto heard = heard_by(reader, "end of robot1");
    EXPECT_EQ(heard.size(), topic_kinds.size()) << name;
  }
}

TEST_F(RightsTest, OutsideOfItsOwnNameARobotWritesNothing) {
  Client hub = member("hub", "#");
  Client robot = member("robot1");
  const std::vector<std::string> denied{"pose",
                                        "echomap/1/other/robot1/pose",
                                        "echomap/2/lab/robot1/pose",
                                        topic("robot11/pose"),
                                        topic("robot/1/pose"),
                                        topic("Robot1/pose"),
                                        topic("hub/pose"),
                                        topic("pose"),
                                        "/" + topic("robot1/pose"),
                                        "$SYS/broker/uptime"};
  for (const std::string& each : denied) {
    robot->publish(each, "forged", Delivery::kAtLeastOnce, true);
  }
  publish_end(robot, "robot1");
  EXPECT_EQ(robot->statistics().refused, denied.size());
  EXPECT_EQ(heard_by(hub, "end of robot1").size(), 1U);
}

TEST_F(RightsTest, TheHubWritesBelowItsOwnNameAndReadsTheBrokersState) {
  Client watcher = member("watcher", topic("#"));
  Client hub = member("hub", "$SYS/broker/version");
  publish_end(hub, "hub");
  EXPECT_EQ(heard_by(watcher, "end of hub").size(), 1U);
  EXPECT_TRUE(hub.serve_until([&] { return !hub.heard().empty(); }));

  Client robot = member("robot1", "$SYS/#");
  robot->subscribe(topic("robot1/#"));
  publish_end(robot, "robot1");
  EXPECT_EQ(heard_by(robot, "end of robot1").size(), 1U);
}

TEST_F(RightsTest, AForeignWillIsNotDelivered) {
  Client watcher = member("watcher", topic("#"));
  ConnectionParams params = broker_.params("robot2");
  params.will = mqtt::LastWill{topic("robot1/presence"), "gone", true};
  { const Client leaving(params); }
  params.will = mqtt::LastWill{topic("robot2/presence"), "robot2 gone", true};
  { const Client leaving(params); }
  const auto heard = heard_by(watcher, "robot2 gone");
  EXPECT_THAT(heard, Not(Contains(testing::Key(topic("robot1/presence")))));
}

TEST_F(RightsTest, AForeignEmptyPayloadClearsNothing) {
  Client owner = member("robot1");
  owner->publish(topic("robot1/manifest"), "all I have", Delivery::kAtLeastOnce, true);
  ASSERT_TRUE(owner.is_acknowledged());
  for (const std::string name : {"robot2", "hub"}) {
    Client other = member(name);
    other->publish(topic("robot1/manifest"), "", Delivery::kAtLeastOnce, true);
    other->publish(topic("robot1/manifest"), "", Delivery::kAtMostOnce, true);
    publish_end(other, name);
  }
  Client late = member("watcher", topic("#"));
  EXPECT_FALSE(heard_by(late, "all I have").empty());
}

// By client id the rights of another could be had: `%c` is what a client says of itself.
TEST_F(RightsTest, AForgedClientIdGivesNoRights) {
  Client watcher = member("watcher", topic("#"));
  ConnectionParams params = broker_.params("robot2");
  params.client_id = "robot1";
  Client thief(params);
  publish_every_kind(*thief, "thief");
  publish_end(thief, "robot2");
  EXPECT_EQ(heard_by(watcher, "end of robot2").size(), 1U);
}

}  // namespace
}  // namespace echomap::broker
