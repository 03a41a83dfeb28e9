// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#if defined(__AVR__)
#include <avr/pgmspace.h>
/// Keeps a constant table out of the RAM; read it with `read_flash`.
#define ECHOMAP_FLASH PROGMEM
#else
#define ECHOMAP_FLASH
#endif

namespace echomap {
namespace hal {

/// Reads one entry of a table that is declared ECHOMAP_FLASH.
inline uint8_t read_flash(const uint8_t* entry) {
#if defined(__AVR__)
  return pgm_read_byte(entry);
#else
  return *entry;
#endif
}

}  // namespace hal
}  // namespace echomap
