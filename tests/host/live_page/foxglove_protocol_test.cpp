// SPDX-License-Identifier: MIT
#include "host/live_page/foxglove_protocol.hpp"

#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

using testing::HasSubstr;

/// Keeps what is sent until it is taken.
class HeldFrames final : public FrameSender {
 public:
  void send(Frame frame) override { frames.push_back(std::move(frame)); }
  void close() override {}

  std::vector<Frame> frames;
};

class FoxgloveProtocolTest : public testing::Test {
 protected:
  FoxgloveProtocolTest() {
    topics.on_topic({1, "/map", "nav_msgs/msg/OccupancyGrid", ""});
    topics.on_topic({2, "/odom", "nav_msgs/msg/Odometry", ""});
  }
  void connect() {
    client = foxglove_protocols(topics).at(0).connect(sender);
    client->on_text(
        R"({"op": "subscribe", "subscriptions": [{"id": 0, "channelId": 1}, {"id": 1, "channelId": 2}]})");
  }
  void add(std::uint32_t topic, std::size_t bytes) {
    const std::vector<std::uint8_t> data(bytes);
    topics.on_message(topic, 1, data);
  }

  FoxgloveTopics topics{"run"};
  std::shared_ptr<HeldFrames> sender = std::make_shared<HeldFrames>();
  std::unique_ptr<SocketProtocol> client;
};

TEST_F(FoxgloveProtocolTest, IsSpokenUnderBothNames) {
  const auto protocols = foxglove_protocols(topics);
  ASSERT_EQ(protocols.size(), 2U);
  EXPECT_EQ(protocols[0].name, "foxglove.websocket.v1");
  EXPECT_EQ(protocols[1].name, "foxglove.sdk.v1");
}

TEST_F(FoxgloveProtocolTest, SendsWhatIsNewUntilTheClientHasGone) {
  connect();
  ASSERT_EQ(sender->frames.size(), 2U);
  EXPECT_THAT(*sender->frames[0].bytes, HasSubstr("serverInfo"));
  EXPECT_TRUE(sender->frames[0].is_text);
  add(2, 10);
  ASSERT_EQ(sender->frames.size(), 4U) << "a time and a message";
  EXPECT_FALSE(sender->frames[3].is_text);
  client->on_binary("\x01");
  EXPECT_THAT(*sender->frames.back().bytes, HasSubstr("status"));
  client.reset();
  add(2, 10);
  EXPECT_EQ(sender->frames.size(), 5U);
}

TEST_F(FoxgloveProtocolTest, LeavesMessagesOutWhileAClientDoesNotReadButNoMap) {
  connect();
  constexpr std::size_t kBytes = kMaxWaitingFoxgloveBytes / 4;
  sender->frames.clear();
  for (int i = 0; i < 100; ++i) {
    add(2, kBytes);
  }
  ASSERT_EQ(sender->frames.size(), 5U) << "a time and four messages";
  EXPECT_NE(sender->frames[1].channel, sender->frames[2].channel) << "none replaces another";
  add(1, kBytes);
  add(1, kBytes);
  ASSERT_EQ(sender->frames.size(), 7U);
  EXPECT_EQ(sender->frames[5].channel, sender->frames[6].channel);
  sender->frames.clear();
  add(2, kBytes);
  EXPECT_EQ(sender->frames.size(), 1U) << "it has read";
}

TEST_F(FoxgloveProtocolTest, ClientsComeAndGoWhileTheRunGoesOn) {
  std::jthread run([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      add(2, 10);
    }
  });
  for (int i = 0; i < 200; ++i) {
    sender = std::make_shared<HeldFrames>();
    connect();
    client->on_text(R"({"op": "unsubscribe", "subscriptionIds": [1]})");
    client.reset();
    EXPECT_GE(sender->frames.size(), 2U);
  }
}

}  // namespace
}  // namespace echomap::live_page
