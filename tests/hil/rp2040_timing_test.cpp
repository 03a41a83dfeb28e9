// SPDX-License-Identifier: MIT
/// What the program takes of an RP2040, in the cycles that rp2040js counts.
#include <cstdio>
#include <memory>

#include <gtest/gtest.h>

#include "tests/hil/measure/chip_figures.hpp"
#include "tests/hil/measure/loaded_robot.hpp"
#include "tests/hil/measure/robot_on_the_move.hpp"
#include "tests/hil/release_images.hpp"

namespace echomap::tests {
namespace {

constexpr const char* kMeasuredImage = "echomap-pico";
constexpr double kMeasuredS = 2.0;

ChipLoad load_at(double edges_per_s) {
  LoadedRobot robot(release_image(kMeasuredImage), {.edges_per_s = edges_per_s, .full_line = true});
  robot.connect();
  const auto meter = make_chip_meter(robot.session().board());
  robot.run_s(kMeasuredS);
  return meter->load();
}

TEST(PicoLoad, EdgesTakeNothingOfItsProcessorAndItsTickIsPunctual) {
  const ChipLoad slow = load_at(2'000);
  const ChipLoad fast = load_at(80'000);
  std::printf("busy %.2f %% at 2,000 edges/s, %.2f %% at 80,000; tick within %.1f us\n",
              100.0 * slow.busy_share,
              100.0 * fast.busy_share,
              fast.tick_jitter_us);
  EXPECT_GT(slow.busy_share, 0.005);
  EXPECT_NEAR(fast.busy_share, slow.busy_share, 0.002) << "156,000 edges a second more";
  EXPECT_LE(fast.busy_share, 0.05);
  EXPECT_LE(fast.tick_jitter_us, 10.0);
}

TEST(PicoLoad, HungProgramIsAllBusy) {
  constexpr std::int64_t kBeforeTheWatchdogNs = 50'000'000;
  RobotOnTheMove moving(release_image(kMeasuredImage));
  moving.drive();
  runner::SimulatedBoard& board = moving.robot.board();
  moving.robot.chip().hang();
  const auto meter = make_chip_meter(board);
  board.run_until(board.now_ns() + kBeforeTheWatchdogNs);
  EXPECT_GT(meter->load().busy_share, 0.999);
}

}  // namespace
}  // namespace echomap::tests
