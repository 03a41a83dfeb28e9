// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <filesystem>
#include <functional>
#include <string>

#include "tests/hil/measure/robot_on_the_move.hpp"

namespace echomap::tests {

/// Where a program hangs.
struct HangPlace {
  std::string file;  ///< "firmware/tasks/safety.cpp"
  bool in_interrupt = false;

  friend auto operator<=>(const HangPlace&, const HangPlace&) = default;
};

/// Lets an AVR's program go on at a jump to itself with interrupts locked.
void hang_with_interrupts_locked(RobotOnTheMove& moving);

using HangReport = std::function<void(const HangPlace& place, const HangOutcome& outcome)>;
/// Lets an AVR robot do all that it can do, again and again, each time with an instruction of
/// another of its files in its flash that jumps to itself; tells what became of it.
void plant_hangs(const std::filesystem::path& elf, const HangReport& report);

/// The longest from one of these hangs to PWM off. Milliseconds.
double measure_hang_ms(const std::filesystem::path& elf);

}  // namespace echomap::tests
