// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace echomap::tests {

/// The clock of the brick's parts where they are tested alone.
void set_clock_us(std::uint32_t now_us);
std::uint32_t clock_of_test_us();

}  // namespace echomap::tests
