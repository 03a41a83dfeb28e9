// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#if defined(__AVR__)
#include <util/crc16.h>
#endif

namespace echomap {
namespace protocol {

/// One byte of CRC-16 with polynomial 0x1021, reflected (0x8408); 24 cycles a byte on AVR.
inline uint16_t crc16_update(uint16_t crc, uint8_t byte) {
#if defined(__AVR__)
  return _crc_ccitt_update(crc, byte);
#else
  uint8_t folded = static_cast<uint8_t>(byte ^ (crc & 0xFFU));
  folded = static_cast<uint8_t>(folded ^ static_cast<uint8_t>(folded << 4));
  return static_cast<uint16_t>(((static_cast<uint16_t>(folded) << 8) | (crc >> 8)) ^
                               static_cast<uint8_t>(folded >> 4) ^
                               (static_cast<uint16_t>(folded) << 3));
#endif
}

/// CRC of `size` bytes, started at `seed` and complemented. The complement keeps runs of 0xFF 0x00
/// from passing as a frame of their own.
inline uint16_t crc16(const uint8_t* data, uint8_t size, uint16_t seed) {
  uint16_t crc = seed;
  for (uint8_t i = 0; i < size; ++i) {
    crc = crc16_update(crc, data[i]);
  }
  return static_cast<uint16_t>(~crc);
}

}  // namespace protocol
}  // namespace echomap
