// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace echomap::tests {

/// The longest from a hang of a driving robot to PWM off, over endless loops of the program and
/// ticks that stop, each at ten moments of the tick: what every emulator can do. Milliseconds,
/// infinite where the motors stay on.
double measure_board_hangs_ms(const std::filesystem::path& elf);

}  // namespace echomap::tests
