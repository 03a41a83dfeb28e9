// SPDX-License-Identifier: MIT
#include "host/session/open_robot.hpp"

#include <gtest/gtest.h>

#include "host/transport/transport_error.hpp"
#include "tests/host/transport/pty_pair.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::session {
namespace {

TEST(SessionId, IsNeverThatOfARobotWhichHasJustStarted) {
  for (const std::uint32_t number : {0U, 1U, 0xFFFEU, 0xFFFFU, 0x10000U, 0xFFFFFFFFU}) {
    EXPECT_NE(session_id_from(number), 0) << number;
  }
}

TEST(OpenRobot, WaitsForARobotOnADeskAsLongAsItIsTold) {
  const transport::PtyPair pty;
  ConnectionOptions options;
  options.ports = {pty.name()};
  options.reconnect_s = 2.5;
  options.no_reset = true;
  const OpenedRobot robot = open_robot(options, Seed(1));
  EXPECT_EQ(robot.lockstep, nullptr);
  EXPECT_EQ(robot.connection.patience, std::chrono::milliseconds(2500));
  EXPECT_TRUE(robot.connection.no_reset);
  EXPECT_EQ(robot.connection.stream->name(), pty.name());
}

TEST(OpenRobot, SaysThatNobodyGrantsTime) {
  const transport::PtyPair pty;
  const tests::ScratchFolder scratch;
  ConnectionOptions options;
  options.ports = {pty.name()};
  options.lockstep = scratch / "nobody";
  EXPECT_THROW(open_robot(options, Seed(1)), transport::TransportError);
}

}  // namespace
}  // namespace echomap::session
