// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Rate at which a board calls `on_tick`.
constexpr uint16_t kTickHz = 1000;

/// Microseconds since the start, modulo 2^32 (71.6 minutes). Callable with interrupts locked.
uint32_t now_us();

}  // namespace hal
}  // namespace echomap
