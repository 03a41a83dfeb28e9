// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Why the board last started, bits of protocol::ResetCause; 0 where a bootloader has hidden it,
/// which hides a watchdog only when its warning could not run.
uint8_t reset_cause();

/// A number that is another one after every reset, a power cut included.
uint16_t boot_id();

}  // namespace hal
}  // namespace echomap
