// SPDX-License-Identifier: MIT
#include "hil_mock/runner/stop_signal.hpp"

#include <csignal>
#include <cstdlib>

#include <gtest/gtest.h>

namespace echomap::runner {
namespace {

/// Exit code 0 where `signal` has asked for an end and nothing had before.
[[noreturn]] void raise_and_exit(int signal) {
  catch_stop_signals();
  const bool before = stop_requested();
  std::raise(signal);
  std::_Exit(!before && stop_requested() ? 0 : 1);
}

TEST(StopSignalDeathTest, IntAndTermAskForAnEndInsteadOfKilling) {
  EXPECT_EXIT(raise_and_exit(SIGINT), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(raise_and_exit(SIGTERM), testing::ExitedWithCode(0), "");
}

TEST(StopSignalDeathTest, ABrokenPipeIsNoSignal) {
  EXPECT_EXIT(raise_and_exit(SIGPIPE), testing::ExitedWithCode(1), "");
}

}  // namespace
}  // namespace echomap::runner
