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
using tests::connected;
using tests::is_acknowledged;

/// One topic of each kind below a robot's name.
const std::vector<std::string> topic_kinds{"presence",
                                           "pose",
                                           "submap/6f1c",
                                           "graph",
                                           "manifest",
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
  static std::map<std::string, std::multiset<std::string>> heard_by(Connection& client,
                                                                    const std::string& end) {
    std::map<std::string, std::multiset<std::string>> heard;
    for (const Message& message : tests::heard_until(client, end)) {
      heard[message.topic].insert(message.payload);
    }
    EXPECT_FALSE(heard.empty());
    return heard;
  }

  /// The last message of a role, which it may write.
  static void publish_end(Connection& role, const std::string& name) {
    role.publish(topic(name + "/clock"), "end of " + name, Delivery::kAtLeastOnce, false);
    EXPECT_TRUE(is_acknowledged(role));
  }

  std::unique_ptr<Connection> member(const std::string& name, const std::string& filter = "") {
    return connected(broker_.params(name), filter);
  }

  tests::RunningBroker broker_{tests::broker_settings({"robot1", "robot2", "watcher", "hub"})};
};

TEST_F(RightsTest, OfEveryKindOnlyTheOwnersIsDelivered) {
  const auto watcher = member("watcher", topic("#"));
  for (const std::string name : {"robot2", "hub"}) {
    const auto role = member(name);
    publish_every_kind(*role, name);
    publish_end(*role, name);
    EXPECT_EQ(role->statistics().refused, topic_kinds.size()) << name;
    EXPECT_EQ(role->last_refused()->reason, mqtt::Reason::kNotAuthorized);
  }
  const auto owner = member("robot1");
  publish_every_kind(*owner, "robot1");
  publish_end(*owner, "robot1");
  EXPECT_EQ(owner->statistics().refused, 0U);

  const auto heard = heard_by(*watcher, "end of robot1");
  for (const std::string& kind : topic_kinds) {
    auto payloads = heard.at(topic("robot1/" + kind));
    payloads.erase("end of robot1");
    EXPECT_THAT(payloads, ElementsAre("robot1", "robot1")) << kind;
  }
}

TEST_F(RightsTest, OfStrangersNothingIsDelivered) {
  const auto watcher = member("watcher", topic("#"));
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
  publish_end(*member("robot1"), "robot1");
  EXPECT_EQ(heard_by(*watcher, "end of robot1").size(), 1U);
}

TEST_F(RightsTest, EveryMemberReadsTheFleet) {
  std::map<std::string, std::unique_ptr<Connection>> readers;
  for (const std::string name : {"robot1", "robot2", "hub"}) {
    readers[name] = member(name, "#");
  }
  publish_every_kind(*readers["robot1"], "robot1");
  publish_end(*readers["robot1"], "robot1");
  for (const auto& [name, reader] : readers) {
    const auto heard = heard_by(*reader, "end of robot1");
    EXPECT_EQ(heard.size(), topic_kinds.size()) << name;
  }
}

TEST_F(RightsTest, OutsideOfItsOwnNameARobotWritesNothing) {
  const auto hub = member("hub", "#");
  const auto robot = member("robot1");
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
  publish_end(*robot, "robot1");
  EXPECT_EQ(robot->statistics().refused, denied.size());
  EXPECT_EQ(heard_by(*hub, "end of robot1").size(), 1U);
}

TEST_F(RightsTest, TheHubWritesBelowItsOwnNameAndReadsTheBrokersState) {
  const auto watcher = member("watcher", topic("#"));
  const auto hub = member("hub", "$SYS/broker/version");
  publish_end(*hub, "hub");
  EXPECT_EQ(heard_by(*watcher, "end of hub").size(), 1U);
  std::vector<Message> heard;
  EXPECT_TRUE(tests::serve_until(*hub, heard, [&] { return !heard.empty(); }));

  const auto robot = member("robot1", "$SYS/#");
  robot->subscribe(topic("robot1/#"));
  publish_end(*robot, "robot1");
  EXPECT_EQ(heard_by(*robot, "end of robot1").size(), 1U);
}

TEST_F(RightsTest, AForeignWillIsNotDelivered) {
  const auto watcher = member("watcher", topic("#"));
  ConnectionParams params = broker_.params("robot2");
  params.will = mqtt::LastWill{topic("robot1/presence"), "gone", true};
  connected(params).reset();
  params.will = mqtt::LastWill{topic("robot2/presence"), "robot2 gone", true};
  connected(params).reset();
  const auto heard = heard_by(*watcher, "robot2 gone");
  EXPECT_THAT(heard, Not(Contains(testing::Key(topic("robot1/presence")))));
}

TEST_F(RightsTest, AForeignEmptyPayloadClearsNothing) {
  const auto owner = member("robot1");
  owner->publish(topic("robot1/manifest"), "all I have", Delivery::kAtLeastOnce, true);
  ASSERT_TRUE(is_acknowledged(*owner));
  for (const std::string name : {"robot2", "hub"}) {
    const auto other = member(name);
    other->publish(topic("robot1/manifest"), "", Delivery::kAtLeastOnce, true);
    other->publish(topic("robot1/manifest"), "", Delivery::kAtMostOnce, true);
    publish_end(*other, name);
  }
  const auto late = member("watcher", topic("#"));
  EXPECT_FALSE(heard_by(*late, "all I have").empty());
}

// By client id the rights of another could be had: `%c` is what a client says of itself.
TEST_F(RightsTest, AForgedClientIdGivesNoRights) {
  const auto watcher = member("watcher", topic("#"));
  ConnectionParams params = broker_.params("robot2");
  params.client_id = "robot1";
  const auto thief = connected(params);
  publish_every_kind(*thief, "thief");
  publish_end(*thief, "robot2");
  EXPECT_EQ(heard_by(*watcher, "end of robot2").size(), 1U);
}

}  // namespace
}  // namespace echomap::broker
