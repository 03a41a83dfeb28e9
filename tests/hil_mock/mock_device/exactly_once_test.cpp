// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "hil_mock/mock_device/mock_board.hpp"
#include "tests/hil_mock/mock_device/lossy_commands.hpp"

namespace echomap::mock_device {
namespace {

TEST(ExactlyOnce, TenThousandCommandsOverALineThatLosesOneFrameInTwenty) {
  constexpr int kCommands = 10'000;
  const LossyCommands result = measure_commands(std::make_unique<MockBoard>(), kCommands, 0.05);
  EXPECT_EQ(result.accepted, kCommands);
  EXPECT_EQ(result.exactly_once, kCommands);
  EXPECT_GT(result.statistics.commands_resent, 900U);
  EXPECT_GT(result.statistics.frames_lost, 1000U);
  EXPECT_EQ(result.sessions, 1U);
}

}  // namespace
}  // namespace echomap::mock_device
