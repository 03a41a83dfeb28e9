// SPDX-License-Identifier: MIT
#include "host/fleet/fleet_knowledge.hpp"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/host/fleet/fleet_of_robots.hpp"

namespace echomap::fleet {
namespace {

using fleet_messages::ClaimMessage;
using fleet_messages::FleetMessage;
using fleet_messages::MessageBody;
using fleet_messages::RefusedReason;
using fleet_messages::TopicKind;

class FleetKnowledgeTest : public testing::Test {
 protected:
  static mqtt::Message message_by(const std::string& robot,
                                  const MessageBody& body,
                                  std::uint32_t counter,
                                  bool is_retained = false) {
    FleetMessage message;
    message.sender = {robot, 1, counter};
    message.body = body;
    const std::string payload = fleet_messages::encode(message).value();
    return {fleet_messages::format_topic(fleet_messages::topic_of("hall", message, payload)),
            payload,
            is_retained};
  }
  static mqtt::Message relayed(const std::string& by, const mqtt::Message& message) {
    return {fleet_messages::format_topic(
                {"hall", by, TopicKind::kRelay, fleet_messages::content_hash(message.payload)}),
            message.payload,
            false};
  }
  mqtt::Message submap_by(const std::string& robot) {
    return message_by(robot, fleet_messages::to_message(random_submap(random_, 0), 0).value(), 0);
  }
  std::size_t refused(RefusedReason reason) const {
    return knowledge_.statistics().refused[static_cast<std::size_t>(reason)];
  }
  bool has(const mqtt::Message& message) const {
    return knowledge_.has(fleet_messages::content_hash(message.payload));
  }

  std::mt19937 random_{1};
  FleetKnowledge knowledge_{"hall", "r1", 16.0};
};

TEST_F(FleetKnowledgeTest, CountsObjectsOnce) {
  const mqtt::Message submap = submap_by("r2");
  knowledge_.take(submap, 1.0);
  const auto revision = knowledge_.revision();
  knowledge_.take(submap, 2.0);
  EXPECT_EQ(knowledge_.object_count(), 1U);
  EXPECT_EQ(knowledge_.revision(), revision);
  EXPECT_EQ(knowledge_.statistics().duplicates, 1U);
  EXPECT_EQ(knowledge_.object_set(),
            fleet_messages::set_hash({fleet_messages::content_hash(submap.payload)}));
}

TEST_F(FleetKnowledgeTest, CountsWhatRobotsHaveMadeAndHasNotCome) {
  EXPECT_EQ(knowledge_.missing_objects(), 0U);
  const mqtt::Message first = submap_by("r2");
  const mqtt::Message second = submap_by("r2");
  knowledge_.take(
      message_by("r2",
                 fleet_messages::ManifestMessage{0,
                                                 {fleet_messages::content_hash(first.payload),
                                                  fleet_messages::content_hash(second.payload)}},
                 1),
      1.0);
  EXPECT_EQ(knowledge_.missing_objects(), 2U);
  knowledge_.take(first, 2.0);
  EXPECT_EQ(knowledge_.missing_objects(), 1U);
  fleet_messages::PresenceMessage presence;
  presence.own_objects = 5;
  knowledge_.take(message_by("r2", presence, 2), 3.0);
  EXPECT_EQ(knowledge_.missing_objects(), 4U) << "pages of the manifest are missing, too";
}

TEST_F(FleetKnowledgeTest, RefusesAnotherFleet) {
  mqtt::Message claim = message_by("r2", ClaimMessage{}, 1);
  claim.topic = "echomap/1/yard/r2/claim";
  knowledge_.take(claim, 0.0);
  EXPECT_EQ(refused(RefusedReason::kWrongTopic), 1U);
  EXPECT_TRUE(knowledge_.robots().empty());
}

TEST_F(FleetKnowledgeTest, TakesALastWillThoughItWasMadeBefore) {
  knowledge_.take(message_by("r2", fleet_messages::PresenceMessage{}, 9), 1.0);
  EXPECT_TRUE(knowledge_.is_alive("r2", 2.0));
  fleet_messages::PresenceMessage will;
  will.state = 2;
  knowledge_.take(message_by("r2", will, 0), 2.0);
  EXPECT_FALSE(knowledge_.is_alive("r2", 2.0));
  EXPECT_EQ(refused(RefusedReason::kReplayed), 0U);
  knowledge_.take(message_by("r2", fleet_messages::PresenceMessage{}, 10), 3.0);
  EXPECT_TRUE(knowledge_.is_alive("r2", 3.0)) << "it has connected again";
}

TEST_F(FleetKnowledgeTest, AcceptsRelaysOfRobotsThatAreNotHere) {
  const mqtt::Message submap = submap_by("r2");
  knowledge_.take(relayed("r3", submap), 1.0);
  EXPECT_TRUE(has(submap));
  EXPECT_FALSE(knowledge_.is_alive("r2", 1.0)) << "a relay is no sign of life";
  knowledge_.take(message_by("r2", ClaimMessage{}, 1), 2.0);
  const mqtt::Message forged = submap_by("r2");
  knowledge_.take(relayed("r3", forged), 3.0);
  EXPECT_FALSE(has(forged));
  EXPECT_EQ(knowledge_.statistics().ignored_relays, 1U);
  knowledge_.take(
      message_by("r2",
                 fleet_messages::ManifestMessage{0, {fleet_messages::content_hash(forged.payload)}},
                 2),
      4.0);
  knowledge_.take(relayed("r3", forged), 5.0);
  EXPECT_TRUE(has(forged)) << "r2 itself has said that it made it";
}

TEST_F(FleetKnowledgeTest, AcceptsAnAuthorThatIsBackWhateverARelayHadOfIt) {
  FleetMessage forged;
  forged.sender = {"r2", 0xFFFFFFFF, 0xFFFFFFFF};
  forged.body = ClaimMessage{0, {{1, 2, 3, 4}}};
  const std::string payload = fleet_messages::encode(forged).value();
  const mqtt::Message relay =
      relayed("r3",
              {fleet_messages::format_topic(fleet_messages::topic_of("hall", forged, payload)),
               payload,
               false});
  forged.body = fleet_messages::to_graph_message({{}}, Eigen::Matrix3d::Zero(), 0).value();
  const std::string graph = fleet_messages::encode(forged).value();
  knowledge_.take(
      relayed("r3",
              {fleet_messages::format_topic(fleet_messages::topic_of("hall", forged, graph)),
               graph,
               false}),
      1.0);
  knowledge_.take(relay, 1.0);
  const mqtt::Message own = message_by(
      "r2",
      fleet_messages::to_graph_message({{}, {1.0, 0.0, 0.0}}, Eigen::Matrix3d::Zero(), 0).value(),
      7);
  knowledge_.take(own, 2.0);
  EXPECT_TRUE(knowledge_.is_alive("r2", 2.0));
  EXPECT_EQ(refused(RefusedReason::kOldBoot) + refused(RefusedReason::kReplayed), 0U);
  EXPECT_EQ(knowledge_.stored("r2").at(own.topic).payload, own.payload);
}

TEST_F(FleetKnowledgeTest, RefusesMoreThanARobotMayMake) {
  for (std::uint32_t i = 0; i <= kMaxObjectsOfARobot; ++i) {
    knowledge_.take(message_by("r2", fleet_messages::SourceMessage{0, i, 0, {{}}}, 0), 1.0);
  }
  EXPECT_EQ(knowledge_.object_count(), kMaxObjectsOfARobot);
  EXPECT_EQ(refused(RefusedReason::kOverQuota), 1U);
  for (std::uint16_t map = 0; map <= kMaxMapsOfARobot; ++map) {
    knowledge_.take(message_by("r3", fleet_messages::GraphMessage{map, {}, {{}}}, 1U + map), 1.0);
  }
  EXPECT_EQ(refused(RefusedReason::kOverQuota), 2U);
  knowledge_.take(message_by("r3", fleet_messages::GraphMessage{7, {}, {{1}}}, 900), 2.0);
  EXPECT_EQ(refused(RefusedReason::kOverQuota), 2U) << "that map is known";
}

TEST_F(FleetKnowledgeTest, RefusesRobotsThatAFleetHasNoRoomFor) {
  for (std::size_t i = 0; i <= kMaxRobots; ++i) {
    knowledge_.take(message_by("n" + std::to_string(i), fleet_messages::PresenceMessage{}, 1), 1.0);
  }
  EXPECT_EQ(knowledge_.robots().size(), kMaxRobots);
  EXPECT_EQ(refused(RefusedReason::kOverQuota), 1U);
}

TEST_F(FleetKnowledgeTest, NoticesWhatALatePresenceShowsIsMissing) {
  const mqtt::Message claim = message_by("r2", ClaimMessage{0, {{1, 2, 3, 4}}}, 1);
  fleet_messages::PresenceMessage presence;
  presence.latest_set = fleet_messages::set_hash({fleet_messages::content_hash(claim.payload)});
  knowledge_.take(message_by("r2", presence, 2), 1.0);
  EXPECT_TRUE(knowledge_.is_behind("r2"));
  knowledge_.take(claim, 2.0);
  knowledge_.take(message_by("r2", presence, 3), 3.0);
  EXPECT_FALSE(knowledge_.is_behind("r2"));
}

TEST_F(FleetKnowledgeTest, HandsOverQuestionsAndWhatIsFoundOfItsOwn) {
  knowledge_.take(message_by("r2", fleet_messages::AskMessage{"r1", 1, {}}, 1), 1.0);
  const auto requests = knowledge_.take_requests();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].from, "r2");
  EXPECT_TRUE(knowledge_.take_requests().empty());
  mqtt::Message own = submap_by("r1");
  own.is_retained = true;
  knowledge_.take(own, 1.0);
  ASSERT_EQ(knowledge_.take_found_own().size(), 1U);
}

TEST_F(FleetKnowledgeTest, IgnoresRetainedTopicsThatWereDeleted) {
  knowledge_.take({"echomap/1/hall/r2/relay/00", "", false}, 1.0);
  EXPECT_EQ(refused(RefusedReason::kWrongTopic), 0U);
}

}  // namespace
}  // namespace echomap::fleet
