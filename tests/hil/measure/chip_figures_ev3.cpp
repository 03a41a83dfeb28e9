// SPDX-License-Identifier: MIT
#include "tests/hil/measure/board_hangs.hpp"
#include "tests/hil/measure/chip_figures.hpp"

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
  return measure_board_crash_ms(elf);
}

}  // namespace echomap::tests
