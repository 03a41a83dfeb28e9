// SPDX-License-Identifier: MIT
#include "host/fleet/publications.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/fleet_messages/payload.hpp"
#include "tests/host/fleet/fleet_of_robots.hpp"

namespace echomap::fleet {
namespace {

using fleet_messages::ClaimMessage;
using fleet_messages::FleetTopic;
using fleet_messages::TopicKind;
using testing::ElementsAre;

/// A bus that only notes what is published.
class NotingBus final : public mqtt::MessageBus {
 public:
  bool publish(const std::string& topic,
               std::string_view payload,
               mqtt::Delivery delivery,
               bool retain) override {
    topics.push_back(topic.substr(topic.rfind("r1/") + 3));
    payloads.emplace_back(payload);
    deliveries.push_back(delivery);
    retained.push_back(retain);
    return payload.size() < 10000;
  }
  void subscribe(const std::string& /*filter*/) override {}
  std::vector<mqtt::Message> take() override { return {}; }
  bool is_connected() const override { return true; }
  std::size_t connections() const override { return 1; }

  std::vector<std::string> topics;
  std::vector<std::string> payloads;
  std::vector<mqtt::Delivery> deliveries;
  std::vector<bool> retained;
};

FleetTopic topic_for(TopicKind kind, fleet_messages::TopicId id = {}) {
  return {"hall", "r1", kind, id};
}

class PublicationsTest : public testing::Test {
 protected:
  void put(TopicKind kind, Worth worth) {
    publications_.put(topic_for(kind), ClaimMessage{}, worth);
  }
  std::string put_object(const std::string& payload) {
    const FleetTopic topic = topic_for(TopicKind::kSubmap, fleet_messages::content_hash(payload));
    publications_.put(topic, payload, Worth::kObject);
    return fleet_messages::format_topic(topic);
  }
  void send(double now_s) {
    publications_.send(
        bus_,
        [this](const fleet_messages::MessageBody& /*body*/) {
          return std::optional("body " + std::to_string(++counter_));
        },
        now_s);
  }

  NotingBus bus_;
  Publications publications_{FleetOfRobots::params_of("r1")};
  int counter_ = 0;
};

TEST_F(PublicationsTest, SendsObjectsAsTheyAreAndBodiesWithACounter) {
  put(TopicKind::kClaim, Worth::kUrgent);
  put(TopicKind::kPose, Worth::kUrgent);
  send(0.0);
  put_object("object");
  send(1.0);
  EXPECT_THAT(bus_.payloads, ElementsAre("body 1", "body 2", "object"));
  EXPECT_THAT(bus_.retained, ElementsAre(true, false, true));
  EXPECT_EQ(bus_.deliveries[1], mqtt::Delivery::kAtMostOnce) << "a pose";
  EXPECT_EQ(bus_.deliveries[2], mqtt::Delivery::kAtLeastOnce);
}

TEST_F(PublicationsTest, SendsOnlyTheLatestOfATopic) {
  put(TopicKind::kClaim, Worth::kUrgent);
  put(TopicKind::kClaim, Worth::kUrgent);
  send(0.0);
  EXPECT_THAT(bus_.topics, ElementsAre("claim"));
  EXPECT_EQ(publications_.waiting(), 0U);
}

TEST_F(PublicationsTest, SharesTheBudgetByWorth) {
  for (int i = 0; i < 100; ++i) {
    put_object(std::to_string(i) + std::string(500, 'x'));
  }
  for (int tenth = 0; tenth < 600; ++tenth) {
    put(TopicKind::kClaim, Worth::kUrgent);  // More claims than anyone needs.
    send(0.1 * tenth);
  }
  const auto claims = std::count(bus_.topics.begin(), bus_.topics.end(), "claim");
  EXPECT_GT(claims, 60) << "one between any two objects";
  EXPECT_GT(static_cast<std::ptrdiff_t>(bus_.topics.size()) - claims, 60);
  EXPECT_LT(publications_.statistics().bytes, 4000U + 60U * 1000U);
}

TEST_F(PublicationsTest, LetsAPoseOvertakeObjects) {
  for (int i = 0; i < 20; ++i) {
    put_object(std::to_string(i) + std::string(500, 'x'));
  }
  send(0.0);
  const std::size_t sent = bus_.topics.size();
  ASSERT_LT(sent, 20U);
  put(TopicKind::kPose, Worth::kUrgent);
  send(1.5);
  ASSERT_GT(bus_.topics.size(), sent);
  EXPECT_EQ(bus_.topics[sent], "pose");
}

TEST_F(PublicationsTest, SendsAgainWhatDidNotComeBack) {
  const std::string confirmed = put_object("one");
  put_object("other");
  send(0.0);
  publications_.confirm(confirmed, "one");
  EXPECT_EQ(publications_.unconfirmed(), 1U);
  publications_.compare(19.0);
  EXPECT_EQ(publications_.waiting(), 0U);
  publications_.compare(21.0);
  send(21.0);
  EXPECT_THAT(bus_.payloads, ElementsAre("one", "other", "other"));
  EXPECT_EQ(publications_.statistics().published_again, 1U);
}

TEST_F(PublicationsTest, SendsAgainWhatANewConnectionDoesNotGive) {
  const std::string first = put_object("one");
  const std::string second = put_object("other");
  send(0.0);
  publications_.confirm(first, "one");
  publications_.confirm(second, "other");
  publications_.on_connected(30.0);
  publications_.confirm(second, "other");
  publications_.confirm(first, "an older one");
  publications_.compare(34.0);
  EXPECT_EQ(publications_.waiting(), 0U) << "it may be on its way";
  publications_.compare(36.0);
  send(36.0);
  EXPECT_THAT(bus_.payloads, ElementsAre("one", "other", "one"));
}

TEST_F(PublicationsTest, StopsWaitingWhenItComesBackAfterAll) {
  const std::string topic = put_object("one");
  send(0.0);
  publications_.compare(30.0);
  EXPECT_EQ(publications_.waiting(), 1U);
  publications_.confirm(topic, "one");
  EXPECT_EQ(publications_.waiting(), 0U);
}

TEST_F(PublicationsTest, RepeatsNotTooOften) {
  const std::string topic = put_object("one");
  send(0.0);
  EXPECT_TRUE(publications_.repeat(topic, 5.0));
  EXPECT_EQ(publications_.waiting(), 0U);
  EXPECT_TRUE(publications_.repeat(topic, 11.0));
  EXPECT_EQ(publications_.waiting(), 1U);
  EXPECT_FALSE(publications_.repeat("another", 11.0));
}

TEST_F(PublicationsTest, SendsWhatWasRestoredOnlyWhereTheBrokerLacksIt) {
  const FleetTopic object = topic_for(TopicKind::kSubmap, fleet_messages::content_hash("one"));
  const FleetTopic graph = topic_for(TopicKind::kGraph, std::uint16_t{0});
  publications_.restore(object, std::string("one"), "one", Worth::kObject);
  publications_.restore(graph, fleet_messages::GraphMessage{}, "old bytes", Worth::kGraph);
  publications_.on_connected(0.0);
  publications_.compare(1.0);
  EXPECT_EQ(publications_.waiting(), 0U);
  publications_.confirm(fleet_messages::format_topic(object), "one");
  publications_.compare(10.0);
  send(10.0);
  EXPECT_THAT(bus_.payloads, ElementsAre("body 1")) << "with a counter of this boot";
}

TEST_F(PublicationsTest, WithdrawsWithEmptyBytes) {
  const std::string topic = put_object("one");
  send(0.0);
  publications_.withdraw(topic);
  send(1.0);
  EXPECT_THAT(bus_.payloads, ElementsAre("one", ""));
  EXPECT_FALSE(publications_.has(topic));
}

TEST_F(PublicationsTest, DropsWhatTheBrokerDoesNotTake) {
  put_object(std::string(20000, 'x'));
  send(0.0);
  EXPECT_EQ(publications_.statistics().too_large, 1U);
  EXPECT_EQ(publications_.waiting(), 0U);
}

TEST_F(PublicationsTest, HashesWhatWasSentOfAKind) {
  put(TopicKind::kClaim, Worth::kUrgent);
  put_object("object");
  const auto is_claim = [](TopicKind kind) { return kind == TopicKind::kClaim; };
  EXPECT_TRUE(publications_.sent_hashes(is_claim).empty());
  send(0.0);
  EXPECT_THAT(publications_.sent_hashes(is_claim),
              ElementsAre(fleet_messages::content_hash("body 1")));
}

}  // namespace
}  // namespace echomap::fleet
