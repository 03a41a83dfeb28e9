// SPDX-License-Identifier: MIT
#include "firmware/hal/stack.hpp"

#include "firmware/boards/cortex_common/stack_paint.hpp"

/// End of the static data, by the linker: the stack grows down towards it.
extern "C" const uint32_t _end;

namespace echomap {
namespace hal {

uint16_t min_free_stack_bytes() {
  constexpr uint8_t kWordsPerCall = 16;
  static const uint32_t* next = &_end;
  static uint16_t free_bytes = 0;
  for (uint8_t i = 0; i < kWordsPerCall; ++i) {
    if (*next != boards::kStackPaint) {
      free_bytes = static_cast<uint16_t>((next - &_end) * 4);
      next = &_end;
      break;
    }
    ++next;
  }
  return free_bytes;
}

}  // namespace hal
}  // namespace echomap
