// SPDX-License-Identifier: MIT
#include "tests/firmware/boards/ev3/set_clock.hpp"

#include "firmware/hal/clock.hpp"

namespace {

std::uint32_t set_us = 0;

}  // namespace

namespace echomap::tests {

void set_clock_us(std::uint32_t now_us) { set_us = now_us; }
std::uint32_t clock_of_test_us() { return set_us; }

}  // namespace echomap::tests

namespace echomap::hal {

uint32_t now_us() { return set_us; }

}  // namespace echomap::hal
