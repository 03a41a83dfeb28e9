// SPDX-License-Identifier: MIT
#pragma once

#include "hil_mock/emulator/avr_machine.hpp"

namespace echomap::tests {

inline constexpr double kCyclesPerUs = emulator::kClockHz / 1e6;

}  // namespace echomap::tests
