// SPDX-License-Identifier: MIT
#include "hil_mock/runner/lockstep_seat.hpp"

#include <gtest/gtest.h>

#include "hil_mock/runner/pty_endpoint.hpp"
#include "tests/hil_mock/runner/fake_board.hpp"
#include "tests/hil_mock/runner/test_host.hpp"
#include "tests/hil_mock/world/rooms.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::runner {
namespace {

using tests::kMs;

class LockstepSeatTest : public testing::Test {
 protected:
  LockstepSeatTest() {
    seat.take_request();
    EXPECT_EQ(channel.read_line(), "hello");
  }

  tests::ScratchFolder folder;
  FakeBoard board;
  world::RobotWorld robot_world{world::box_room(), {}, 1};
  RobotSimulation simulation{board, robot_world};
  PtyEndpoint endpoint{folder / "robot", WhenUnread::kKeep};
  LockstepServer server{folder / "lockstep", "hello"};
  LockstepSeat seat{simulation, endpoint, server};
  TestHost bytes = TestHost::open_terminal(endpoint.address());
  TestHost channel = TestHost::connect_local(folder / "lockstep");
};

TEST_F(LockstepSeatTest, AGrantHoldsUntilItIsAnswered) {
  EXPECT_EQ(seat.granted_ns(), std::nullopt);
  ASSERT_TRUE(seat.accept({20000, 0}));
  EXPECT_EQ(seat.granted_ns(), 20 * kMs);
  simulation.advance_to(20 * kMs);
  seat.answer();
  EXPECT_EQ(channel.read_line(), "reached 20000 0");
  EXPECT_EQ(seat.granted_ns(), std::nullopt);
}

TEST_F(LockstepSeatTest, GivesTheBoardTheBytesOfTheGrantAndNoMore) {
  bytes.write("onetwo");
  ASSERT_TRUE(seat.accept({10000, 3}));
  EXPECT_EQ(board.received.size(), 3U);
  simulation.advance_to(10 * kMs);
  seat.answer();
  EXPECT_EQ(channel.read_line(), "reached 10000 3");
  EXPECT_EQ(bytes.read(3), "one");
}

TEST_F(LockstepSeatTest, TellsTheTruthToWhoWantsIt) {
  seat.tell_truth();
  ASSERT_TRUE(seat.accept({0, 0}));
  seat.answer();
  EXPECT_EQ(channel.read_line(), "reached 0 0 0 0 0");
}

TEST_F(LockstepSeatTest, WhatIsDiscardedIsNotCounted) {
  bytes.write("abc");
  ASSERT_TRUE(seat.accept({10000, 3}));
  simulation.advance_to(10 * kMs);
  seat.discard_sent();
  seat.answer();
  EXPECT_EQ(channel.read_line(), "reached 10000 0");
}

}  // namespace
}  // namespace echomap::runner
