// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil/on_every_board.hpp"
#include "tests/hil/turning_wheel.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::tests {
namespace {

using SentBytes = std::vector<std::pair<std::int64_t, std::uint8_t>>;

/// The end of a grant cuts the time of a byte that ends in the same cycle of 62.5 ns: up again.
std::int64_t in_cycles(std::int64_t at_ns) { return (at_ns * 2 + 124) / 125; }

/// Two seconds of everything at once: turning wheels, a sweep with echoes, pings; the board's time
/// granted in steps of `step_ns`.
SentBytes busy_run(const char* image, std::int64_t step_ns) {
  RobotSession robot(release_image(image));
  runner::SimulatedBoard& board = robot.board();
  TurningWheel left(board, runner::Wheel::kLeft);
  TurningWheel right(board, runner::Wheel::kRight);
  board.on_trigger = [&](std::int64_t at_ns) {
    board.schedule_echo(at_ns + 460'000, at_ns + 460'000 + 3'141'592);
  };
  robot.connect();
  robot.command(protocol::StartSweep{0, -9000, 9000, 600, 0});
  for (std::uint32_t i = 0; i < 100; ++i) {
    left.turn(4'321, 20 * kMs);
    right.turn(-1'234, 20 * kMs);
    robot.send(protocol::Ping{i});
    const std::int64_t end_ns = board.now_ns() + 20 * kMs;
    while (board.now_ns() < end_ns) {
      board.run_until(std::min(end_ns, board.now_ns() + step_ns));
    }
  }
  SentBytes bytes = robot.bytes();
  for (auto& [at_ns, byte] : bytes) {
    at_ns = in_cycles(at_ns);
  }
  return bytes;
}

class Determinism : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Boards, Determinism, every_board(), image_label);

TEST_P(Determinism, SameRunTwiceGivesTheSameBytesAtTheSameTimes) {
  const SentBytes first = busy_run(GetParam(), kMs);
  const SentBytes second = busy_run(GetParam(), kMs);
  std::printf("%s: %zu bytes, last after %lld cycles\n",
              GetParam(),
              first.size(),
              static_cast<long long>(first.back().first));
  ASSERT_GT(first.size(), 3000U);
  EXPECT_TRUE(first == second);
}

TEST_P(Determinism, SizeOfTheGrantsDoesNotMatter) {
  const SentBytes coarse = busy_run(GetParam(), 20 * kMs);
  EXPECT_TRUE(coarse == busy_run(GetParam(), kMs));
  EXPECT_TRUE(coarse == busy_run(GetParam(), 370'123));
}

}  // namespace
}  // namespace echomap::tests
