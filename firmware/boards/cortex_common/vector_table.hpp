// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace boards {

/// What an exception calls.
using Handler = void (*)();

/// Vectors of the core, the same for ARMv6-M (B1.5.3) and ARMv7-M (B1.5.3): 0 is the stack's begin.
constexpr uint8_t kCoreVectors = 16;
constexpr uint8_t kResetVector = 1;
constexpr uint8_t kTickVector = 15;

/// Where the stack begins, then a handler for each exception; the chip's interrupt lines come after
/// the vectors of the core.
template <uint8_t kHandlers>
struct VectorTable {
  const uint32_t* stack_top;
  Handler handlers[kHandlers];

  constexpr void set(uint8_t vector, Handler handler) { handlers[vector - 1] = handler; }
  template <class Line>
  constexpr void set_line(Line line, Handler handler) {
    set(static_cast<uint8_t>(kCoreVectors + static_cast<uint8_t>(line)), handler);
  }
};

/// A table of `kLines` interrupt lines in which every exception is a fault.
template <uint8_t kLines>
constexpr VectorTable<kCoreVectors + kLines - 1> table_of_faults(const uint32_t* stack_top,
                                                                 Handler on_fault) {
  VectorTable<kCoreVectors + kLines - 1> table{};
  table.stack_top = stack_top;
  for (Handler& handler : table.handlers) {
    handler = on_fault;
  }
  return table;
}

}  // namespace boards
}  // namespace echomap
