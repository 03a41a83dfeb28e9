// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace boards {

/// What on_reset fills all RAM between the static data and the stack with.
constexpr uint32_t kStackPaint = 0xC5C5C5C5;

}  // namespace boards
}  // namespace echomap
