// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Least free stack since the start, by paint. Each call looks at a few bytes more, so the answer
/// lags by some 150 calls and none takes long; 0 before that.
uint16_t least_free_stack_bytes();

}  // namespace hal
}  // namespace echomap
