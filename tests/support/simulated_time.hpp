// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace echomap::tests {

/// A millisecond of simulated time, in nanoseconds.
inline constexpr std::int64_t kMs = 1'000'000;

}  // namespace echomap::tests
