// SPDX-License-Identifier: MIT
#include "host/live_page/client_queue.hpp"

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

using testing::ElementsAre;

Frame state(std::uint64_t key, const std::string& text) {
  return {std::make_shared<const std::string>(text), false, FrameChannel{1, key}};
}

std::vector<std::string> rest_of(ClientQueue& queue) {
  std::vector<std::string> texts;
  while (const auto frame = queue.pop()) {
    texts.push_back(*frame->bytes);
  }
  return texts;
}

TEST(ClientQueue, KeepsTheNewestOfEachChannelInItsPlace) {
  ClientQueue queue;
  queue.push(state(1, "a1"));
  queue.push(state(2, "b1"));
  queue.push(state(1, "a2"));
  queue.push(state(1, "a3"));
  EXPECT_THAT(rest_of(queue), ElementsAre("a3", "b1"));
  queue.push(state(1, "a4"));
  EXPECT_THAT(rest_of(queue), ElementsAre("a4"));
}

TEST(ClientQueue, LeavesNothingOutThatHasNoChannel) {
  ClientQueue queue;
  queue.push(text_frame("one"));
  queue.push(state(1, "a"));
  queue.push(text_frame("two"));
  EXPECT_THAT(rest_of(queue), ElementsAre("one", "a", "two"));
}

TEST(ClientQueue, SendsNoTileOfANewMapBeforeItsBeginning) {
  ClientQueue queue;
  queue.push(state(1, "old tile 1"));
  queue.push(state(2, "old tile 2"));
  queue.push(text_frame("new map"));
  queue.push(state(1, "tile 1"));
  queue.push(state(1, "newer tile 1"));
  EXPECT_THAT(rest_of(queue), ElementsAre("old tile 2", "new map", "newer tile 1"));
}

TEST(ClientQueue, RefusesMoreThanAClientMayLeaveUnread) {
  ClientQueue queue(10);
  EXPECT_TRUE(queue.push(text_frame("12345")));
  EXPECT_TRUE(queue.push(state(1, "as much as you like")));
  EXPECT_TRUE(queue.push(text_frame("67890")));
  queue.pop();
  EXPECT_TRUE(queue.push(text_frame("12345")));
  EXPECT_FALSE(queue.push(text_frame("6")));
}

TEST(ClientQueue, DoesNotGrowByStates) {
  ClientQueue queue;
  for (int i = 0; i < 1000; ++i) {
    queue.push(state(i % 3, std::to_string(i)));
  }
  EXPECT_EQ(queue.size(), 3U);
  EXPECT_THAT(rest_of(queue), ElementsAre("999", "997", "998"));
  EXPECT_TRUE(queue.empty());
}

TEST(ClientQueue, SharesTheBytes) {
  ClientQueue queue;
  const auto bytes = std::make_shared<const std::string>("x");
  queue.push({bytes, false, {}});
  EXPECT_EQ(queue.pop()->bytes.get(), bytes.get());
  queue.push({bytes, false, {}});
  queue.clear();
  EXPECT_EQ(bytes.use_count(), 1);
}

}  // namespace
}  // namespace echomap::live_page
