// SPDX-License-Identifier: MIT
#include "protocol/link.hpp"

#include <numeric>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::protocol {
namespace {

// --- ReceiveCounters

ReceiveCounters after_frames(std::initializer_list<int> seqs) {
  ReceiveCounters counters;
  for (const int seq : seqs) {
    counters.take(DecodeStatus::kFrame, static_cast<std::uint8_t>(seq));
  }
  return counters;
}

TEST(ReceiveCounters, LoseNothingInARowThatWraps) {
  const ReceiveCounters counters = after_frames({254, 255, 0, 1});
  EXPECT_EQ(counters.frames_good(), 4);
  EXPECT_EQ(counters.frames_lost(), 0);
}

TEST(ReceiveCounters, CountTheSequenceNumbersThatAreMissing) {
  EXPECT_EQ(after_frames({10, 14}).frames_lost(), 3);
  EXPECT_EQ(after_frames({250, 2, 4}).frames_lost(), 8);
}

TEST(ReceiveCounters, ADamagedFrameIsBadOnceAndLostOnce) {
  ReceiveCounters counters = after_frames({1});
  counters.take(DecodeStatus::kBadCrc, 0);
  counters.take(DecodeStatus::kFrame, 3);
  EXPECT_EQ(counters.frames_good(), 2);
  EXPECT_EQ(counters.frames_bad(), 1);
  EXPECT_EQ(counters.frames_lost(), 1);
}

TEST(ReceiveCounters, DoNotCountTheBytesInsideAFrame) {
  ReceiveCounters counters = after_frames({1});
  counters.take(DecodeStatus::kIncomplete, 77);
  counters.take(DecodeStatus::kFrame, 2);
  EXPECT_EQ(counters.frames_bad() + counters.frames_lost(), 0);
}

TEST(ReceiveCounters, TakeTheFirstFrameAfterARestartAsItComes) {
  ReceiveCounters counters = after_frames({5, 6});
  counters.restart();
  counters.take(DecodeStatus::kFrame, 200);
  counters.take(DecodeStatus::kFrame, 201);
  EXPECT_EQ(counters.frames_lost(), 0);
  EXPECT_EQ(counters.frames_good(), 4);
}

// --- CommandFilter

TEST(CommandFilter, KnowsNoCommandAtFirst) {
  const CommandFilter filter;
  for (int id = 0; id <= 255; ++id) {
    EXPECT_FALSE(filter.is_repeat(static_cast<std::uint8_t>(id)));
  }
}

TEST(CommandFilter, AnswersARepeatAsBefore) {
  CommandFilter filter;
  filter.begin_session(1);
  filter.remember(9, CommandStatus::kBusy);
  EXPECT_TRUE(filter.is_repeat(9));
  EXPECT_FALSE(filter.is_repeat(10));
  EXPECT_EQ(filter.answer().command_id, 9);
  EXPECT_EQ(filter.answer().status, static_cast<std::uint8_t>(CommandStatus::kBusy));
}

TEST(CommandFilter, ForgetsTheLastCommandInANewSessionOnly) {
  CommandFilter filter;
  EXPECT_TRUE(filter.begin_session(0));
  filter.remember(1, CommandStatus::kAccepted);
  EXPECT_FALSE(filter.begin_session(0));
  EXPECT_TRUE(filter.is_repeat(1));
  EXPECT_TRUE(filter.begin_session(7));
  EXPECT_FALSE(filter.is_repeat(1));
}

TEST(CommandFilter, HoldsForItsTimeAfterTheLastWord) {
  CommandFilter filter;
  EXPECT_FALSE(filter.refuses(7));
  filter.begin_session(7);
  EXPECT_EQ(filter.session(), 7);
  EXPECT_FALSE(filter.refuses(7));
  for (int ms = 0; ms < CommandFilter::kHoldMs; ms += 4) {
    ASSERT_TRUE(filter.refuses(8)) << ms;
    filter.pass(4);
  }
  EXPECT_FALSE(filter.refuses(8));
  filter.pass(4);
  EXPECT_FALSE(filter.refuses(8));
  filter.hear();
  EXPECT_TRUE(filter.refuses(8));
}

TEST(CommandFilter, HoldsNothingOnceItIsReleased) {
  CommandFilter filter;
  filter.hear();
  EXPECT_FALSE(filter.refuses(8));
  filter.begin_session(7);
  filter.hold(false);
  filter.hear();
  EXPECT_FALSE(filter.refuses(8));
  filter.hold(true);
  EXPECT_TRUE(filter.refuses(8));
  EXPECT_TRUE(filter.begin_session(8));
  EXPECT_TRUE(filter.refuses(7));
}

TEST(NextCommandId, GoesRoundWithoutZero) {
  std::set<int> ids;
  std::uint8_t id = 1;
  for (int i = 0; i < 255; ++i) {
    ids.insert(id);
    id = next_command_id(id);
  }
  EXPECT_EQ(id, 1);
  EXPECT_EQ(ids.size(), 255U);
  EXPECT_EQ(ids.count(0), 0U);
}

// --- exactly once

/// A robot that does what it is told; it records each command it did.
struct Robot {
  CommandFilter filter;
  std::vector<int> done;

  Ack take(std::uint8_t command_id, int order) {
    if (!filter.is_repeat(command_id)) {
      done.push_back(order);
      filter.remember(command_id, CommandStatus::kAccepted);
    }
    return filter.answer();
  }
};

TEST(CommandFilter, DoesEveryCommandExactlyOnceOverALineThatLosesHalf) {
  std::mt19937 generator(4);
  const auto survives = [&] { return generator() % 2 == 0; };
  Robot robot;
  robot.filter.begin_session(1);
  std::uint8_t command_id = 1;
  for (int order = 0; order < 1000; ++order) {
    bool acknowledged = false;
    while (!acknowledged) {
      acknowledged =
          survives() && robot.take(command_id, order).command_id == command_id && survives();
    }
    command_id = next_command_id(command_id);
  }
  std::vector<int> each_once(1000);
  std::iota(each_once.begin(), each_once.end(), 0);
  EXPECT_EQ(robot.done, each_once);
}

}  // namespace
}  // namespace echomap::protocol
