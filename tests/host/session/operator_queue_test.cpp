// SPDX-License-Identifier: MIT
#include "host/session/operator_queue.hpp"

#include <variant>

#include <gtest/gtest.h>

namespace echomap::session {
namespace {

TEST(OperatorQueue, KeepsTheLatestOfEachKind) {
  OperatorQueue queue;
  queue.push(SteerRobot{0.5, 0.0});
  queue.push(SetSpeed{8.0});
  queue.push(SteerRobot{1.0, 0.0});
  const auto commands = queue.take();
  ASSERT_EQ(commands.size(), 2U);
  EXPECT_EQ(std::get<SetSpeed>(commands[0]).factor, 8.0);
  EXPECT_EQ(std::get<SteerRobot>(commands[1]).forward, 1.0);
  EXPECT_TRUE(queue.take().empty());
}

TEST(OperatorQueue, AStopLetsGoOfAllMotionThatWaits) {
  OperatorQueue queue;
  queue.push(SteerRobot{});
  queue.push(GoTo{});
  queue.push(ResumeStrategy{});
  queue.push(SetSpeed{1.0});
  queue.push(StopRobot{});
  const auto commands = queue.take();
  ASSERT_EQ(commands.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<SetSpeed>(commands[0]));
  EXPECT_TRUE(std::holds_alternative<StopRobot>(commands[1]));
}

}  // namespace
}  // namespace echomap::session
