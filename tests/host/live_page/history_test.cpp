// SPDX-License-Identifier: MIT
#include "host/live_page/history.hpp"

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

using testing::ElementsAre;

SharedMessage message(MessageKind kind, double time_s, std::uint64_t key, const std::string& text) {
  return std::make_shared<const Message>(Message{kind, key, time_s, text});
}

std::vector<std::string> texts_of(const std::vector<SharedMessage>& messages) {
  std::vector<std::string> texts;
  for (const SharedMessage& one : messages) {
    texts.push_back(one->bytes);
  }
  return texts;
}

TEST(History, TellsAClientThatConnectsTheNewestOfEachInOrder) {
  History history;
  history.add(message(MessageKind::kMotion, 0.0, 0, "m0"));
  history.add(message(MessageKind::kTile, 0.0, 7, "tile 7 old"));
  history.add(message(MessageKind::kTile, 0.1, 8, "tile 8"));
  history.add(message(MessageKind::kTile, 0.2, 7, "tile 7"));
  history.add(message(MessageKind::kEvent, 0.2, 0, "event"));
  history.add(message(MessageKind::kHello, 0.2, 0, "hello"));
  history.add(message(MessageKind::kMotion, 0.3, 0, "m3"));
  EXPECT_THAT(texts_of(history.newest()), ElementsAre("hello", "tile 7", "tile 8", "m3"));
}

TEST(History, ForgetsTheOldMapWithANewOne) {
  History history;
  history.add(message(MessageKind::kTile, 0.0, 7, "tile"));
  history.add(message(MessageKind::kTrail, 0.0, 0, "trail"));
  history.add(message(MessageKind::kState, 0.0, 0, "state"));
  history.add(message(MessageKind::kNewMap, 1.0, 0, "new"));
  EXPECT_THAT(texts_of(history.newest()), ElementsAre("state"));
  EXPECT_THAT(texts_of(history.since(0)), ElementsAre("tile", "trail", "state", "new"));
}

TEST(History, KeepsMotionsTenTimesASecondAndPassesAllOn) {
  History history;
  std::size_t passed = 0;
  history.listen([&](const SharedMessage&) { ++passed; });
  for (int i = 0; i < 100; ++i) {
    history.add(message(MessageKind::kMotion, 0.03125 * i, 0, "m"));
  }
  EXPECT_EQ(passed, 100U);
  EXPECT_EQ(history.since(0).size(), 25U);
}

}  // namespace
}  // namespace echomap::live_page
