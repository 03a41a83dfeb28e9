// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace boards {

/// Splits the program into a guard and the robot, and returns in the robot. Nothing on the brick
/// stops a motor whose program has died, so the guard does: when the robot crashes, and when it has
/// not called `tell_guard` for kGuardMs. It then starts the robot again. The robot does so when the
/// guard has died, and ends. SIGTERM, SIGINT and SIGHUP end both.
void start_guard(const char* sysfs, const char* clock);
constexpr uint64_t kGuardMs = 120;

/// The robot lives.
void tell_guard();
/// How often the guard has started it before.
uint16_t starts_before();
/// A number that the guard has drawn at its own start.
uint16_t guard_id();

}  // namespace boards
}  // namespace echomap
