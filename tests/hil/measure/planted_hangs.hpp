// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include "tests/hil/measure/robot_on_the_move.hpp"

namespace echomap::tests {

/// The files of the program's tasks and interrupts that a driving and sweeping robot on an AVR
/// board runs.
const std::set<std::string>& files_of_tasks();

/// Lets an AVR's program go on at a jump to itself with interrupts locked.
void hang_with_interrupts_locked(RobotOnTheMove& moving);

/// Tells of each hang: in which file, and whether in an interrupt, and what became of the robot.
using HangReport =
    std::function<void(const std::string& file, bool in_interrupt, const HangOutcome& outcome)>;
/// Drives an AVR robot again and again, each time with an instruction of another file's in its
/// flash that jumps to itself.
void plant_hangs(const std::filesystem::path& elf, const HangReport& report);

/// The longest from one of these hangs to PWM off. Milliseconds.
double measure_hang_ms(const std::filesystem::path& elf);

}  // namespace echomap::tests
