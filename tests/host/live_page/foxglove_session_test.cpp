// SPDX-License-Identifier: MIT
#include "host/live_page/foxglove_session.hpp"

#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace echomap::live_page {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint64_t kSecondNs = 1'000'000'000;

std::uint64_t number_in(const std::string& bytes, std::size_t offset, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < size; ++i) {
    number |= std::uint64_t{static_cast<std::uint8_t>(bytes.at(offset + i))} << (8 * i);
  }
  return number;
}

/// A frame in words: text as it is, a time, or subscription, log time and data of a message.
std::string shown(const FoxgloveFrame& frame) {
  if (frame.is_text) {
    return frame.bytes;
  }
  if (frame.bytes.at(0) == 2) {
    EXPECT_EQ(frame.bytes.size(), 9U);
    return "time " + std::to_string(number_in(frame.bytes, 1, 8));
  }
  EXPECT_EQ(frame.bytes.at(0), 1);
  return std::to_string(number_in(frame.bytes, 1, 4)) + " at " +
         std::to_string(number_in(frame.bytes, 5, 8)) + ": " + frame.bytes.substr(13);
}

std::vector<std::string> shown(const FoxgloveSession::Frames& frames) {
  std::vector<std::string> all;
  for (const FoxgloveFrame& frame : frames) {
    all.push_back(shown(frame));
  }
  return all;
}

class FoxgloveSessionTest : public testing::Test {
 protected:
  FoxgloveSessionTest() {
    topics.on_topic({1, "/map", "nav_msgs/msg/OccupancyGrid", "int8[] data\n"});
    topics.on_topic({2, "/odom", "nav_msgs/msg/Odometry", "float64 x\n"});
  }
  void add(std::uint32_t topic, std::uint64_t log_time_ns, const std::string& text) {
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    topics.on_message(topic, log_time_ns, bytes);
  }
  std::string status_after(std::string_view text) {
    const auto frames = session.receive_text(text);
    if (frames.size() != 1) {
      return std::to_string(frames.size()) + " frames";
    }
    const json status = json::parse(frames[0].bytes);
    EXPECT_EQ(status.at("op"), "status");
    EXPECT_EQ(status.at("level"), 2);
    return status.at("message");
  }

  FoxgloveTopics topics{"run 1"};
  FoxgloveSession session{topics};
};

TEST_F(FoxgloveSessionTest, BeginsWithWhatTheServerIsAndItsChannels) {
  const auto frames = session.begin();
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(json::parse(frames[0].bytes),
            json::parse(R"({"op": "serverInfo", "name": "echomap", "capabilities": ["time"],
                            "sessionId": "run 1"})"));
  EXPECT_EQ(json::parse(frames[1].bytes), json::parse(R"({"op": "advertise", "channels": [
      {"id": 1, "topic": "/map", "encoding": "cdr", "schemaName": "nav_msgs/msg/OccupancyGrid",
       "schemaEncoding": "ros2msg", "schema": "int8[] data\n"},
      {"id": 2, "topic": "/odom", "encoding": "cdr", "schemaName": "nav_msgs/msg/Odometry",
       "schemaEncoding": "ros2msg", "schema": "float64 x\n"}]})"));
  for (const FoxgloveFrame& frame : frames) {
    EXPECT_TRUE(frame.is_text);
    EXPECT_EQ(frame.delivery, FoxgloveDelivery::kAlways);
  }
}

TEST_F(FoxgloveSessionTest, AdvertisesAlsoWhereThereIsNothingYet) {
  topics.clear();
  EXPECT_EQ(shown(session.begin()).at(1), R"({"channels":[],"op":"advertise"})");
}

TEST_F(FoxgloveSessionTest, SendsTheBytesOfAMessageDataAndOfATime) {
  session.begin();
  session.receive_text(
      R"({"op": "subscribe", "subscriptions": [{"id": 4278255361, "channelId": 2}]})");
  add(2, 0x0102030405060708, "abc");
  const auto frames = session.news();
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].bytes, std::string("\x02\x08\x07\x06\x05\x04\x03\x02\x01", 9));
  EXPECT_EQ(frames[1].bytes,
            std::string("\x01\x01\xff\x00\xff\x08\x07\x06\x05\x04\x03\x02\x01"
                        "abc",
                        16));
  EXPECT_FALSE(frames[0].is_text);
  EXPECT_FALSE(frames[1].is_text);
}

TEST_F(FoxgloveSessionTest, WhoSubscribesGetsTheNewestMessageAndThenEachOnce) {
  add(1, 1 * kSecondNs, "old map");
  add(1, 2 * kSecondNs, "map");
  session.begin();
  add(1, 3 * kSecondNs, "newer map");
  EXPECT_THAT(shown(session.receive_text(
                  R"({"op": "subscribe", "subscriptions": [{"id": 0, "channelId": 1}]})")),
              ElementsAre("time 2000000000", "0 at 3000000000: newer map"));
  add(2, 4 * kSecondNs, "not subscribed");
  add(1, 5 * kSecondNs, "newest map");
  EXPECT_THAT(
      shown(session.news()),
      ElementsAre(
          "time 3000000000", "time 4000000000", "time 5000000000", "0 at 5000000000: newest map"));
  EXPECT_THAT(session.news(), IsEmpty());
  session.receive_text(R"({"op": "unsubscribe", "subscriptionIds": [0]})");
  add(1, 6 * kSecondNs, "unheard");
  EXPECT_THAT(session.news(), IsEmpty());
}

TEST_F(FoxgloveSessionTest, TellsTheTimeAHundredTimesASecondAndBackwardsOnlyForANewRun) {
  session.begin();
  session.receive_text(R"({"op": "subscribe", "subscriptions": [{"id": 5, "channelId": 2}]})");
  add(2, 10 * kSecondNs, "a");
  add(2, 10 * kSecondNs + 9'999'999, "b");
  add(2, 10 * kSecondNs + 10'000'000, "c");
  add(2, 10 * kSecondNs - 1, "d");
  add(2, 1 * kSecondNs, "e");
  EXPECT_THAT(shown(session.news()),
              ElementsAre("time 10000000000",
                          "5 at 10000000000: a",
                          "5 at 10009999999: b",
                          "time 10010000000",
                          "5 at 10010000000: c",
                          "5 at 9999999999: d",
                          "time 1000000000",
                          "5 at 1000000000: e"));
}

TEST_F(FoxgloveSessionTest, AdvertisesANewTopicAndUnadvertisesOneThatIsGone) {
  session.begin();
  session.receive_text(R"({"op": "subscribe", "subscriptions": [{"id": 0, "channelId": 1}]})");
  topics.on_topic({3, "/rosout", "rcl_interfaces/msg/Log", ""});
  EXPECT_THAT(shown(session.news()), ElementsAre(HasSubstr(R"("op":"advertise")")));
  topics.clear();
  topics.on_topic({1, "/map", "nav_msgs/msg/OccupancyGrid", ""});
  add(1, 1, "map");
  EXPECT_THAT(shown(session.news()),
              ElementsAre(R"({"channelIds":[1,2,3],"op":"unadvertise"})", HasSubstr(R"("id":4)")))
      << "the subscription has gone with its channel";
  EXPECT_EQ(status_after(R"({"op": "subscribe", "subscriptions": [{"id": 0, "channelId": 1}]})"),
            "there is no channel 1");
  EXPECT_THAT(shown(session.receive_text(
                  R"({"op": "subscribe", "subscriptions": [{"id": 0, "channelId": 4}]})")),
              ElementsAre("time 1", "0 at 1: map"));
}

TEST_F(FoxgloveSessionTest, ALaterMapReplacesOneThatWaitsWhileOdometryMayBeLost) {
  session.begin();
  session.receive_text(
      R"({"op": "subscribe", "subscriptions": [{"id": 0, "channelId": 1}, {"id": 1, "channelId": 2}]})");
  add(1, 1, "map");
  add(2, 1, "odometry");
  add(1, 2, "map");
  const auto frames = session.news();
  ASSERT_EQ(frames.size(), 4U);
  EXPECT_EQ(frames[0].delivery, FoxgloveDelivery::kNewest) << "the time";
  EXPECT_EQ(frames[1].delivery, FoxgloveDelivery::kNewest);
  EXPECT_EQ(frames[2].delivery, FoxgloveDelivery::kLossy);
  EXPECT_EQ(frames[1].key, frames[3].key);
  EXPECT_NE(frames[0].key, frames[1].key);
}

TEST_F(FoxgloveSessionTest, AnswersWhatItDoesNotTakeWithAStatus) {
  session.begin();
  EXPECT_EQ(status_after(""), "a message is no JSON object with an op");
  EXPECT_EQ(status_after("{"), "a message is no JSON object with an op");
  EXPECT_EQ(status_after("[]"), "a message is no JSON object with an op");
  EXPECT_EQ(status_after(R"({"op": 1})"), "a message is no JSON object with an op");
  EXPECT_EQ(status_after("{\"op\": \"\xff\"}"), "a message is no JSON object with an op");
  EXPECT_EQ(status_after(R"({"op": "fetchAsset"})"), "echomap does not take the op \"fetchAsset\"");
  EXPECT_EQ(status_after(R"({"op": "subscribe"})"), "subscribe has no array of subscriptions");
  EXPECT_EQ(status_after(R"({"op": "unsubscribe", "subscriptionIds": 1})"),
            "unsubscribe has no array of subscriptionIds");
  EXPECT_EQ(status_after(R"({"op": "unsubscribe", "subscriptionIds": [7, null]})"),
            "there is no subscription 7 (and 1 more)");
  EXPECT_EQ(status_after(std::string(FoxgloveSession::kMaxTextBytes + 1, ' ')),
            "a message is longer than 64 KiB");
  EXPECT_THAT(shown(session.receive_binary("\x01")),
              ElementsAre(HasSubstr("echomap takes no binary messages")));
}

TEST_F(FoxgloveSessionTest, AnswersASubscriptionThatCannotBeWithAStatus) {
  session.begin();
  const auto status = [&](const std::string& id, const std::string& channel) {
    return status_after(R"({"op": "subscribe", "subscriptions": [{"id": )" + id +
                        R"(, "channelId": )" + channel + "}]}");
  };
  EXPECT_EQ(status("0", "3"), "there is no channel 3");
  for (const char* id : {"-1", "4294967296", "1.5", "1e300", "\"1\"", "null", "{}", "[[[[1]]]]"}) {
    EXPECT_EQ(status(id, "1"), "a subscription is no pair of id and channelId") << id;
    EXPECT_EQ(status("1", id), "a subscription is no pair of id and channelId") << id;
  }
  EXPECT_EQ(status("0", "1"), "0 frames") << "a good one";
  EXPECT_THAT(status("1", "1"), HasSubstr("has a subscription")) << "the channel has one";
  EXPECT_THAT(status("0", "2"), HasSubstr("has a subscription")) << "the id has one";
  EXPECT_EQ(status("1", "2"), "0 frames");
}

TEST_F(FoxgloveSessionTest, SurvivesWhatIsNestedDeeply) {
  session.begin();
  const std::string deep(FoxgloveSession::kMaxTextBytes - 100, '[');
  status_after(deep);
  const std::string half(FoxgloveSession::kMaxTextBytes / 2 - 100, '[');
  const std::string both = half + std::string(half.size(), ']');
  for (const char* name : {"subscriptions", "subscriptionIds", "op"}) {
    for (const char* op : {"subscribe", "unsubscribe"}) {
      session.receive_text(std::string(R"({"op": ")") + op + R"(", ")" + name + "\": " + both +
                           "}");
    }
  }
  EXPECT_EQ(status_after(both), "a message is no JSON object with an op");
}

TEST_F(FoxgloveSessionTest, AClientThatFloodsLeavesOneStatusWaiting) {
  session.begin();
  const auto first = session.receive_text("x");
  const auto second = session.receive_binary("x");
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].delivery, FoxgloveDelivery::kNewest);
  EXPECT_EQ(first[0].key, second.at(0).key);
}

}  // namespace
}  // namespace echomap::live_page
