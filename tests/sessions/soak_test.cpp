// SPDX-License-Identifier: MIT
/// A short one; `./run bench soak` does a day of it.
#include "tests/sessions/soak.hpp"

#include <gtest/gtest.h>

#include "hil_mock/emulator/simavr_board.hpp"

namespace echomap::tests {
namespace {

class SoakTest : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Images, SoakTest, ::testing::Values("echomap-uno", "echomap-mega"));

TEST_P(SoakTest, NothingDriftsInMinutesOfDrivingSweepingAndFaults) {
  const std::string elf = std::string(ECHOMAP_BINARY_DIR "/firmware/") + GetParam() + ".elf";
  const SoakResult result = soak(std::make_unique<emulator::SimavrBoard>(elf), 0.15, 1);
  EXPECT_EQ(result.failures, 0U);
  EXPECT_EQ(result.worst_drift_ticks, 0);
  EXPECT_LE(result.worst_echo_error_us, 1.0);
  EXPECT_LE(result.worst_lateness_us, 1000.0);
  EXPECT_LE(result.worst_clock_error_us, 1000.0);
  EXPECT_EQ(result.resets, 0U);
  EXPECT_EQ(result.encoder_errors, 0U);
  EXPECT_EQ(result.receive_overruns, 0U);
  EXPECT_LE(result.grown_mb, 8.0);
  EXPECT_TRUE(result.holds());
  EXPECT_GT(result.rounds, 20U);
  EXPECT_GT(result.cuts, 0U);
  EXPECT_GT(result.edges, 100'000U);
  EXPECT_GT(result.echoes, 300U);
  EXPECT_GT(result.frames_lost, 20U) << "the line does nothing";
}

}  // namespace
}  // namespace echomap::tests
