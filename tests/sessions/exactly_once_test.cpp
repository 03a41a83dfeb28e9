// SPDX-License-Identifier: MIT
/// As tests/hil_mock/mock_device/exactly_once_test.cpp, with the release image.
#include <memory>

#include <gtest/gtest.h>

#include "hil_mock/emulator/simavr_board.hpp"
#include "tests/hil_mock/mock_device/lossy_commands.hpp"

namespace echomap::tests {
namespace {

TEST(ExactlyOnceOnTheUno, TenThousandCommandsOverALineThatLosesOneFrameInTwenty) {
  constexpr int kCommands = 10'000;
  auto board =
      std::make_unique<emulator::SimavrBoard>(ECHOMAP_BINARY_DIR "/firmware/echomap-uno.elf");
  const auto result = mock_device::measure_commands(std::move(board), kCommands, 0.05);
  EXPECT_EQ(result.accepted, kCommands);
  EXPECT_EQ(result.exactly_once, kCommands);
  EXPECT_GT(result.statistics.commands_resent, 900U);
  EXPECT_EQ(result.sessions, 1U);
}

}  // namespace
}  // namespace echomap::tests
