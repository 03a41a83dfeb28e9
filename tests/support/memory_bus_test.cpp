// SPDX-License-Identifier: MIT
#include "tests/support/memory_bus.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::tests {
namespace {

using mqtt::Delivery;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> payloads_of(MemoryBus& client) {
  std::vector<std::string> payloads;
  for (const mqtt::Message& message : client.take()) {
    payloads.push_back(message.payload + (message.is_retained ? " retained" : ""));
  }
  return payloads;
}

/// Two clients that are connected; the second hears everything.
class TwoMemoryClients : public testing::Test {
 protected:
  TwoMemoryClients() {
    a_->take();
    b_->subscribe("#");
    b_->take();
  }

  void publish(const std::string& payload, Delivery delivery = Delivery::kAtLeastOnce) {
    EXPECT_TRUE(a_->publish("a/pose", payload, delivery, false));
  }

  MemoryBroker broker_;
  std::unique_ptr<MemoryBus> a_ = broker_.client("a", mqtt::LastWill{"a/presence", "gone", true});
  std::unique_ptr<MemoryBus> b_ = broker_.client("b");
};

/// What is heard of 200 messages, each with the time at which it came.
std::string heard_with(const MemoryBrokerParams& params, std::size_t& lost) {
  MemoryBroker broker(params);
  const auto a = broker.client("a");
  const auto b = broker.client("b");
  b->subscribe("#");
  std::string heard;
  for (int i = 0; i < 230; ++i) {
    broker.advance_to(0.1 * i);
    a->take();
    if (i < 200) {
      a->publish("a/pose", std::to_string(i), Delivery::kAtLeastOnce, false);
    }
    for (const std::string& payload : payloads_of(*b)) {
      heard += payload + "@" + std::to_string(i) + " ";
    }
  }
  lost = broker.lost();
  return heard;
}

TEST(TopicFilter, TakesLevelsAsMqttSays) {
  EXPECT_TRUE(topic_matches("a/+/c", "a/b/c"));
  EXPECT_TRUE(topic_matches("a/#", "a/b/c"));
  EXPECT_TRUE(topic_matches("a/#", "a"));
  EXPECT_TRUE(topic_matches("+/+", "/b"));
  EXPECT_FALSE(topic_matches("a/+", "a"));
  EXPECT_FALSE(topic_matches("a/+", "a/b/c"));
  EXPECT_FALSE(topic_matches("a/b", "a/b/c"));
  EXPECT_FALSE(topic_matches("#", "$SYS/uptime"));
}

TEST_F(TwoMemoryClients, WhatIsPublishedComesInItsOrder) {
  publish("1");
  publish("2", Delivery::kAtMostOnce);
  EXPECT_THAT(payloads_of(*b_), ElementsAre("1", "2"));
  EXPECT_THAT(payloads_of(*b_), IsEmpty());
  EXPECT_EQ(broker_.published_bytes("a"), 14U);
}

TEST_F(TwoMemoryClients, OneWhoSubscribesLateGetsWhatIsRetained) {
  a_->publish("a/manifest", "old", Delivery::kAtLeastOnce, true);
  a_->publish("a/manifest", "new", Delivery::kAtLeastOnce, true);
  const auto late = broker_.client("late");
  late->subscribe("+/manifest");
  EXPECT_THAT(payloads_of(*late), ElementsAre("new retained"));
  a_->publish("a/manifest", "", Delivery::kAtLeastOnce, true);
  EXPECT_THAT(broker_.retained(), IsEmpty());
}

TEST_F(TwoMemoryClients, OneThatIsCutOffIsTheBrokersToReport) {
  broker_.cut("a");
  EXPECT_THAT(payloads_of(*b_), ElementsAre("gone"));
  publish("kept");
  publish("not kept", Delivery::kAtMostOnce);
  a_->take();
  EXPECT_FALSE(a_->is_connected());
  broker_.resume("a");
  a_->take();
  EXPECT_EQ(a_->connections(), 2U);
  EXPECT_THAT(payloads_of(*b_), ElementsAre("kept"));
}

TEST_F(TwoMemoryClients, OneThatDisconnectsLeavesNoWill) {
  a_->disconnect();
  a_.reset();
  EXPECT_THAT(payloads_of(*b_), IsEmpty());
}

TEST_F(TwoMemoryClients, ARestartLosesWhatWasOnItsWayAndPartOfWhatIsRetained) {
  for (int i = 0; i < 100; ++i) {
    a_->publish("a/submap/" + std::to_string(i), "x", Delivery::kAtLeastOnce, true);
  }
  broker_.restart(0.5);
  EXPECT_GT(broker_.retained().size(), 20U);
  EXPECT_LT(broker_.retained().size(), 80U);
  EXPECT_FALSE(b_->is_connected());
  EXPECT_EQ(b_->take().size(), broker_.retained().size());
  EXPECT_EQ(b_->connections(), 2U);
}

TEST_F(TwoMemoryClients, RefusesWhatIsTooLarge) {
  EXPECT_FALSE(a_->publish("a/x", std::string(300000, 'x'), Delivery::kAtLeastOnce, false));
  EXPECT_THAT(payloads_of(*b_), IsEmpty());
}

TEST(MemoryBroker, DelaysLosesAndRepeatsBySeed) {
  const MemoryBrokerParams params{7, 2.0, 0.1, 0.1, 1000};
  std::size_t lost = 0;
  const std::string heard = heard_with(params, lost);
  EXPECT_EQ(heard, heard_with(params, lost));
  EXPECT_GT(lost, 5U);
  EXPECT_LT(lost, 50U);
  const auto count = static_cast<std::size_t>(std::ranges::count(heard, '@'));
  EXPECT_GT(count, 200U - lost);
  EXPECT_LT(count, 250U);

  MemoryBrokerParams other = params;
  other.seed = 8;
  EXPECT_NE(heard, heard_with(other, lost));
}

}  // namespace
}  // namespace echomap::tests
