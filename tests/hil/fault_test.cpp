// SPDX-License-Identifier: MIT
/// What a fault of the core leads to, on chips that notice one: the AVR boards do not.
#include <gtest/gtest.h>

#include "tests/hil/measure/robot_on_the_move.hpp"
#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

class FaultedRobot : protected RobotOnTheMove, public ::testing::TestWithParam<const char*> {
 protected:
  FaultedRobot() : RobotOnTheMove(release_image(GetParam())) {}
};

INSTANTIATE_TEST_SUITE_P(Boards, FaultedRobot, every_board(), image_label);

TEST_P(FaultedRobot, SwitchesOffAndStartsAgainAtOnce) {
  constexpr double kOneStepMs = 1.0;
  drive();
  robot.chip().crash();
  const HangOutcome outcome = outcome_of_hang();
  EXPECT_LE(outcome.off_ms, kOneStepMs);
  EXPECT_LE(outcome.reset_ms, kOneStepMs);
  EXPECT_TRUE(outcome.stayed_off);
  robot.run_ms(300);
  EXPECT_EQ(robot.chip().resets(), 1U);
  ASSERT_TRUE(robot.connect(4712));
  EXPECT_EQ(robot.last<protocol::HelloReply>()->reset_cause, protocol::kResetWatchdog);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, 100, 100, 500, 0}),
            protocol::CommandStatus::kDisarmed);
}

}  // namespace
}  // namespace echomap::tests
