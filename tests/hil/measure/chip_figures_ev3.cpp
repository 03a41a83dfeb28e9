// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>

#include "tests/hil/measure/board_hangs.hpp"
#include "tests/hil/measure/chip_figures.hpp"
#include "tests/hil/measure/robot_on_the_move.hpp"

namespace echomap::tests {

std::unique_ptr<ChipMeter> make_chip_meter(runner::SimulatedBoard& /*board*/) { return nullptr; }

/// Its pan is a motor and no servo, whose pulses measure_commands compares.
std::unique_ptr<runner::SimulatedBoard> make_owned_board(const std::filesystem::path& /*elf*/) {
  return nullptr;
}

std::optional<double> measure_sample_to_pwm_us(const std::filesystem::path& /*elf*/) { return {}; }

double measure_worst_hang_ms(const std::filesystem::path& elf) {
  return measure_board_hangs_ms(elf);
}

std::optional<double> measure_crash_off_ms(const std::filesystem::path& elf) {
  double longest_ms = 0.0;
  for (std::int64_t moment_us = 0; moment_us < 4000; moment_us += 400) {
    RobotOnTheMove moving(elf);
    moving.drive();
    moving.robot.board().run_until(moving.robot.board().now_ns() + moment_us * 1000);
    moving.robot.chip().crash();
    longest_ms = std::max(longest_ms, moving.outcome_of_hang().off_ms);
  }
  return longest_ms;
}

}  // namespace echomap::tests
