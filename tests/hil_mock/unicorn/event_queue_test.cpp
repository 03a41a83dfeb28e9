// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/event_queue.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

class Queue : public ::testing::Test {
 protected:
  void note_at(std::uint64_t cycle, int name) {
    queue.at(cycle, [this, name] { called.emplace_back(queue.now(), name); });
  }

  EventQueue queue;
  std::vector<std::pair<std::uint64_t, int>> called;
};

TEST_F(Queue, CallsInOrderOfTimeAndThoseOfOneCycleInTheirOwn) {
  note_at(20, 3);
  note_at(10, 1);
  note_at(20, 4);
  note_at(15, 2);
  queue.skip_to(20);
  EXPECT_THAT(called, ElementsAre(Pair(10, 1), Pair(15, 2), Pair(20, 3), Pair(20, 4)));
}

TEST_F(Queue, SetsTheTimeBackForAnEventThatTheCpuHasRunPast) {
  note_at(10, 1);
  queue.spend(17);
  EXPECT_TRUE(called.empty());
  queue.call_due();
  EXPECT_THAT(called, ElementsAre(Pair(10, 1)));
  EXPECT_EQ(queue.now(), 17U);
}

TEST_F(Queue, CallsWhatIsOverAtOnce) {
  queue.spend(100);
  note_at(10, 1);
  EXPECT_EQ(queue.next(), 100U);
  queue.call_due();
  EXPECT_THAT(called, ElementsAre(Pair(100, 1)));
}

TEST_F(Queue, AnEventMayBringTheNextOne) {
  queue.at(10, [this] { note_at(12, 2); });
  queue.skip_to(11);
  EXPECT_TRUE(called.empty());
  EXPECT_EQ(queue.next(), 12U);
  queue.skip_to(12);
  EXPECT_THAT(called, ElementsAre(Pair(12, 2)));
  EXPECT_EQ(queue.next(), UINT64_MAX);
}

}  // namespace
}  // namespace echomap::unicorn
