// SPDX-License-Identifier: MIT
#include "tests/hil/measure/board_hangs.hpp"

#include <algorithm>
#include <cstdint>

#include "tests/hil/measure/robot_on_the_move.hpp"

namespace echomap::tests {
namespace {

double off_after_ms(const std::filesystem::path& elf,
                    std::int64_t moment_us,
                    void (EmulatedBoard::*fail)()) {
  RobotOnTheMove moving(elf);
  moving.drive();
  moving.robot.board().run_until(moving.robot.board().now_ns() + moment_us * 1000);
  (moving.robot.chip().*fail)();
  return moving.outcome_of_hang().off_ms;
}

}  // namespace

double measure_board_hangs_ms(const std::filesystem::path& elf) {
  double longest_ms = 0.0;
  for (std::int64_t moment_us = 0; moment_us < 1000; moment_us += 100) {
    longest_ms = std::max({longest_ms,
                           off_after_ms(elf, moment_us, &EmulatedBoard::hang),
                           off_after_ms(elf, moment_us, &EmulatedBoard::stop_ticks)});
  }
  return longest_ms;
}

double measure_board_crash_ms(const std::filesystem::path& elf) {
  double longest_ms = 0.0;
  for (std::int64_t moment_us = 0; moment_us < 4000; moment_us += 400) {
    longest_ms = std::max(longest_ms, off_after_ms(elf, moment_us, &EmulatedBoard::crash));
  }
  return longest_ms;
}

}  // namespace echomap::tests
