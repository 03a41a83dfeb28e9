// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace echomap::tests {

/// The longest from a hang of a driving robot to PWM off, over endless loops of the program and
/// ticks that stop, each at ten moments of the tick: what every emulator can do. Milliseconds,
/// infinite where the motors stay on.
double measure_board_hangs_ms(const std::filesystem::path& elf);

/// The longest from a crash of a driving robot's program to PWM off, over ten moments of the
/// control period. Milliseconds.
double measure_board_crash_ms(const std::filesystem::path& elf);

}  // namespace echomap::tests
