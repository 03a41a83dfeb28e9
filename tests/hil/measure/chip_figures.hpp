// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "tests/hil/measure/loaded_robot.hpp"

namespace echomap::tests {

/// What can be measured only with a hold on the chip itself. Each program has one of the files
/// chip_figures_simavr.cpp, chip_figures_unicorn.cpp, chip_figures_ev3.cpp or
/// chip_figures_rp2040.cpp.

/// What a program takes of its chip.
struct ChipLoad {
  double busy_share = 0.0;  ///< Of the time, in which the chip does not sleep.
  double tick_jitter_us = 0.0;
};

/// Measures from its making on.
class ChipMeter {
 public:
  virtual ~ChipMeter() = default;
  virtual ChipLoad load() const = 0;
};

/// Null where the emulator does not tell. `board` outlives the meter; one at a time.
std::unique_ptr<ChipMeter> make_chip_meter(runner::SimulatedBoard& board);

/// The board alone, which owns its emulator; null where this program's is none that can be owned
/// so.
std::unique_ptr<runner::SimulatedBoard> make_owned_board(const std::filesystem::path& elf);

/// From encoder sample to PWM register, the longest; empty where the emulator does not tell.
std::optional<double> measure_sample_to_pwm_us(const std::filesystem::path& elf);

/// The longest from a hang to PWM off, over the hangs that the emulator can plant. Milliseconds.
double measure_worst_hang_ms(const std::filesystem::path& elf);

/// The longest from a crash of the program to PWM off; empty on boards whose program cannot crash,
/// for neither a system nor the core notices. Milliseconds.
std::optional<double> measure_crash_off_ms(const std::filesystem::path& elf);

}  // namespace echomap::tests
