// SPDX-License-Identifier: MIT
#include "host/mqtt/outbox.hpp"

#include <string>

#include <gtest/gtest.h>

namespace echomap::mqtt {
namespace {

/// Payloads in the order in which they would be sent.
std::string waiting_payloads(Outbox outbox) {
  std::string payloads;
  for (int id = 1000; outbox.next() != nullptr; ++id) {
    payloads += outbox.next()->payload + " ";
    outbox.note_sent(id);
  }
  return payloads;
}

TEST(Outbox, KeepsTheOrderAndWhatIsOnItsWayUntilItIsAnswered) {
  Outbox outbox({10, 1000});
  for (const char* const payload : {"a", "b", "c"}) {
    EXPECT_EQ(outbox.push("t", payload, false), 0U);
  }
  outbox.note_sent(7);
  outbox.note_sent(8);
  EXPECT_EQ(waiting_payloads(outbox), "c ");
  EXPECT_FALSE(outbox.take_answered(9));
  EXPECT_EQ(outbox.take_answered(8)->payload, "b");
  EXPECT_EQ(outbox.sent(), 1U);
  outbox.reset_sent();
  EXPECT_EQ(waiting_payloads(outbox), "a c ");
}

TEST(Outbox, OfARetainedTopicOnlyTheNewestWaits) {
  Outbox outbox({10, 1000});
  outbox.push("graph", "old", true);
  outbox.push("submap/1", "s1", true);
  outbox.push("graph", "new", true);
  EXPECT_EQ(waiting_payloads(outbox), "s1 new ");
}

TEST(Outbox, WhatIsOnItsWayIsNotReplaced) {
  Outbox outbox({10, 1000});
  outbox.push("graph", "old", true);
  outbox.note_sent(1);
  outbox.push("graph", "new", true);
  EXPECT_EQ(outbox.size(), 2U);
  EXPECT_EQ(outbox.take_answered(1)->payload, "old");
  EXPECT_EQ(waiting_payloads(outbox), "new ");
}

TEST(Outbox, TheOldestThatWaitsMakesRoom) {
  Outbox outbox({3, 1000});
  outbox.push("t", "sent", false);
  outbox.note_sent(1);
  outbox.push("t", "a", false);
  outbox.push("t", "b", false);
  EXPECT_EQ(outbox.push("t", "c", false), 1U);
  EXPECT_EQ(waiting_payloads(outbox), "b c ");
  EXPECT_EQ(outbox.size(), 3U);
}

TEST(Outbox, IsBoundedInBytes) {
  Outbox outbox({100, 100});
  EXPECT_EQ(outbox.push("t", std::string(59, 'a'), false), 0U);
  EXPECT_EQ(outbox.push("t", std::string(59, 'b'), false), 1U);
  EXPECT_EQ(outbox.next()->payload[0], 'b');
  outbox.note_sent(1);
  EXPECT_EQ(outbox.push("t", std::string(59, 'c'), false), 1U) << "what is on its way stays";
  EXPECT_EQ(outbox.size(), 1U);
}

TEST(Outbox, DropsTheNextOnRequest) {
  Outbox outbox({100, 100});
  outbox.push("t", "a", false);
  outbox.drop_next();
  EXPECT_TRUE(outbox.empty());
  EXPECT_EQ(outbox.push("t", std::string(99, 'a'), false), 0U) << "its bytes are free again";
}

}  // namespace
}  // namespace echomap::mqtt
