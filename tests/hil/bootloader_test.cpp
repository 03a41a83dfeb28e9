// SPDX-License-Identifier: MIT
/// Behind Optiboot, which clears MCUSR before the firmware starts.
#include <gtest/gtest.h>

#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

class BehindABootloader : public OnEveryBoard {
 protected:
  BehindABootloader() { robot.chip().hide_reset_cause(); }
};

INSTANTIATE_TEST_SUITE_P(Boards, BehindABootloader, every_board(), image_label);

TEST_P(BehindABootloader, AHangIsKnownAsTheWatchdogs) {
  ASSERT_TRUE(robot.connect());
  robot.chip().hang();
  robot.run_ms(300);
  const auto reply = robot.connect(4712);
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(reply->reset_cause, protocol::kResetWatchdog);
}

TEST_P(BehindABootloader, EveryOtherCauseReadsZero) {
  const auto first = robot.connect();
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->reset_cause, 0);
  robot.chip().hang();
  robot.run_ms(300);
  robot.chip().pull_reset_pin();
  const auto reply = robot.connect(4712);
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(reply->reset_cause, 0) << "the hang was told by the start before";
}

}  // namespace
}  // namespace echomap::tests
