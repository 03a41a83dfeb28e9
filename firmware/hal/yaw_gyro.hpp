// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// True on a board whose gyro sums up by itself; the two-wire bus is then not asked for one.
bool has_yaw_gyro();
/// True when `degrees`, turned to the left since the start modulo 2^16, is what the gyro says now.
bool read_yaw_deg(int16_t& degrees);

}  // namespace hal
}  // namespace echomap
