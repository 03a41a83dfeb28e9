// SPDX-License-Identifier: MIT
#include "host/live_page/foxglove_topics.hpp"

#include <limits>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class FoxgloveTopicsTest : public testing::Test {
 protected:
  void add(std::uint32_t topic, std::size_t bytes = 1) {
    const std::vector<std::uint8_t> data(bytes);
    topics.on_message(topic, ++time_ns, data);
  }
  std::vector<std::uint64_t> numbers_since(std::uint64_t number) const {
    std::vector<std::uint64_t> numbers;
    for (const SharedFoxgloveMessage& message : topics.since(number).messages) {
      numbers.push_back(message->number);
    }
    return numbers;
  }
  std::vector<std::string> channels() const {
    std::vector<std::string> channels;
    for (const SharedFoxgloveChannel& channel : topics.channels()) {
      channels.push_back(std::to_string(channel->id) + " " + channel->topic);
    }
    return channels;
  }

  FoxgloveTopics topics{"one"};
  std::uint64_t time_ns = 0;
};

TEST_F(FoxgloveTopicsTest, HasTheNewestOfEachChannelAndWhatCameSince) {
  topics.on_topic({7, "/map", "nav_msgs/msg/OccupancyGrid", "..."});
  topics.on_topic({9, "/odom", "nav_msgs/msg/Odometry", "..."});
  EXPECT_EQ(topics.newest(1), nullptr);
  add(7);
  add(9);
  add(9);
  add(8);
  EXPECT_THAT(channels(), ElementsAre("1 /map", "2 /odom"));
  EXPECT_EQ(topics.newest(1)->number, 1U);
  EXPECT_EQ(topics.newest(2)->number, 3U);
  EXPECT_THAT(numbers_since(0), ElementsAre(1, 2, 3)) << "topic 8 has no channel";
  EXPECT_THAT(numbers_since(2), ElementsAre(3));
  EXPECT_THAT(numbers_since(3), IsEmpty());
  const auto last = topics.since(std::numeric_limits<std::uint64_t>::max());
  EXPECT_THAT(last.messages, IsEmpty());
  EXPECT_EQ(last.last_number, 3U);
  EXPECT_EQ(last.log_time_ns, 3U);
}

TEST_F(FoxgloveTopicsTest, KeepsTheNewestMapWhereOtherMessagesHavePushedItOut) {
  topics.on_topic({1, "/map", "", ""});
  topics.on_topic({2, "/odom", "", ""});
  add(1);
  for (std::size_t i = 0; i < 2 * FoxgloveTopics::kMaxKeptMessages; ++i) {
    add(2);
  }
  const auto numbers = numbers_since(0);
  EXPECT_EQ(numbers.size(), 1 + FoxgloveTopics::kMaxKeptMessages);
  EXPECT_EQ(numbers.front(), 1U);
  EXPECT_EQ(numbers.back(), 1 + 2 * FoxgloveTopics::kMaxKeptMessages);
  EXPECT_EQ(numbers_since(1).size(), FoxgloveTopics::kMaxKeptMessages) << "it is there already";
}

TEST_F(FoxgloveTopicsTest, KeepsOnlySoManyBytesButAlwaysTheLastMessage) {
  topics.on_topic({1, "/map", "", ""});
  for (int i = 0; i < 10; ++i) {
    add(1, FoxgloveTopics::kMaxKeptBytes / 2);
  }
  EXPECT_THAT(numbers_since(0), ElementsAre(9, 10));
  add(1, 2 * FoxgloveTopics::kMaxKeptBytes);
  EXPECT_THAT(numbers_since(0), ElementsAre(11));
}

TEST_F(FoxgloveTopicsTest, ATopicWithAnotherSchemaIsAnotherChannel) {
  topics.on_topic({1, "/map", "a", ""});
  add(1);
  const auto generation = topics.since(0).generation;
  topics.on_topic({1, "/map", "a", ""});
  EXPECT_EQ(topics.since(0).generation, generation);
  EXPECT_NE(topics.newest(1), nullptr);
  topics.on_topic({1, "/map", "b", ""});
  EXPECT_NE(topics.since(0).generation, generation);
  EXPECT_THAT(channels(), ElementsAre("2 /map"));
  EXPECT_EQ(topics.newest(1), nullptr);
}

TEST_F(FoxgloveTopicsTest, ForgetsARunButReusesNoNumber) {
  topics.on_topic({1, "/map", "", ""});
  add(1);
  topics.clear();
  EXPECT_THAT(channels(), IsEmpty());
  EXPECT_THAT(numbers_since(0), IsEmpty());
  topics.on_topic({1, "/map", "", ""});
  add(1);
  EXPECT_THAT(channels(), ElementsAre("2 /map"));
  EXPECT_THAT(numbers_since(0), ElementsAre(2));
}

TEST_F(FoxgloveTopicsTest, TakesOnlySoManyChannels) {
  for (std::uint32_t i = 1; i <= 2 * FoxgloveTopics::kMaxChannels; ++i) {
    topics.on_topic({i, "/" + std::to_string(i), "", ""});
    add(i);
  }
  EXPECT_EQ(topics.channels().size(), FoxgloveTopics::kMaxChannels);
  EXPECT_EQ(topics.since(0).last_number, FoxgloveTopics::kMaxChannels);
}

TEST_F(FoxgloveTopicsTest, WakesEachListenerWithEachNewsUntilItIsTakenAway) {
  int calls = 0;
  int other_calls = 0;
  const auto number = topics.listen([&] { ++calls; });
  topics.listen([&] { ++other_calls; });
  topics.on_topic({1, "/map", "", ""});
  add(1);
  add(2);
  topics.clear();
  EXPECT_EQ(calls, 3) << "topic 2 has no channel";
  topics.unlisten(number);
  topics.on_topic({1, "/map", "", ""});
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(other_calls, 4);
}

TEST_F(FoxgloveTopicsTest, IsReadWhileAnotherThreadAdds) {
  topics.on_topic({1, "/odom", "", ""});
  constexpr std::uint64_t kMessages = 20'000;
  std::jthread adding([&] {
    for (std::uint64_t i = 0; i < kMessages; ++i) {
      add(1);
    }
  });
  std::uint64_t last = 0;
  while (last < kMessages) {
    for (const SharedFoxgloveMessage& message : topics.since(last).messages) {
      ASSERT_GT(message->number, last);
      last = message->number;
    }
  }
  EXPECT_EQ(topics.newest(1)->number, kMessages);
}

}  // namespace
}  // namespace echomap::live_page
