// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Least free stack since the start, by paint. Each call looks at a few bytes more, so that none
/// takes long: the answer lags by the calls that go through all of the free RAM, two seconds on
/// the AVR. 0 before that.
uint16_t min_free_stack_bytes();

}  // namespace hal
}  // namespace echomap
