// SPDX-License-Identifier: MIT
#include "host/fleet/missing_watch.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/fleet/fleet_of_robots.hpp"

namespace echomap::fleet {
namespace {

using fleet_messages::content_hash;

class MissingWatchTest : public testing::Test {
 protected:
  void say(const fleet_messages::MessageBody& body) {
    fleet_messages::FleetMessage message;
    message.sender = {"r2", 1, ++counter_};
    message.body = body;
    const std::string payload = fleet_messages::encode(message).value();
    knowledge_.take(
        {fleet_messages::format_topic(fleet_messages::topic_of("hall", message, payload)),
         payload,
         false},
        0.0);
  }

  FleetKnowledge knowledge_{"hall", "r1", 1e9};
  MissingWatch watch_{FleetOfRobots::params_of("r1")};
  std::uint32_t counter_ = 0;
};

TEST_F(MissingWatchTest, RequestsAfterAWhileWhatWasPromised) {
  say(fleet_messages::ManifestMessage{0, {content_hash("a"), content_hash("b")}});
  EXPECT_FALSE(watch_.next(knowledge_, 0.0));
  EXPECT_FALSE(watch_.next(knowledge_, 7.0)) << "it may be on its way";
  const auto request = watch_.next(knowledge_, 9.0);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->robot, "r2");
  EXPECT_EQ(request->objects.size(), 2U);
  EXPECT_EQ(request->everything_else, 0);
}

TEST_F(MissingWatchTest, RequestsLessAndLessOftenWithoutAnAnswer) {
  say(fleet_messages::ManifestMessage{0, {content_hash("a")}});
  int requests = 0;
  for (int second = 0; second < 1000; ++second) {
    requests += watch_.next(knowledge_, second) ? 1 : 0;
  }
  EXPECT_GE(requests, 6);
  EXPECT_LE(requests, 12);
}

TEST_F(MissingWatchTest, RequestsManifestAndGraphsWhereThePresenceAnnouncesMore) {
  fleet_messages::PresenceMessage presence;
  presence.own_objects = 3;
  presence.latest_set = fleet_messages::set_hash({});
  say(presence);
  watch_.next(knowledge_, 0.0);
  const auto request = watch_.next(knowledge_, 9.0);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->everything_else, 1);
}

TEST_F(MissingWatchTest, RequestsNothingWhereNothingIsMissing) {
  fleet_messages::PresenceMessage presence;
  presence.latest_set = fleet_messages::set_hash({});
  say(presence);
  watch_.next(knowledge_, 0.0);
  EXPECT_FALSE(watch_.next(knowledge_, 100.0));
}

TEST_F(MissingWatchTest, RequestsAPageAtATime) {
  for (std::uint16_t page = 0; page < 3; ++page) {
    std::vector<fleet_messages::ContentHash> objects;
    for (int i = 0; i < 32; ++i) {
      objects.push_back(content_hash(std::to_string(100 * page + i)));
    }
    say(fleet_messages::ManifestMessage{page, objects});
  }
  watch_.next(knowledge_, 0.0);
  const auto request = watch_.next(knowledge_, 9.0);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->objects.size(), 32U);
}

}  // namespace
}  // namespace echomap::fleet
