// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace echomap::boards {

/// Bytes of a second boot stage before its checksum.
constexpr std::size_t kBoot2CheckedBytes = 252;

/// CRC-32/MPEG-2, bit by bit through a register of its own.
inline std::uint32_t checksum_of(std::span<const std::uint8_t> bytes) {
  std::uint32_t remainder = 0xFFFFFFFF;
  for (std::size_t at = 0; at < bytes.size() * 8; ++at) {
    const std::uint32_t in = bytes[at / 8] >> (7 - at % 8) & 1U;
    const std::uint32_t out = remainder >> 31;
    remainder = (remainder << 1) ^ ((in ^ out) != 0 ? 0x04C11DB7U : 0U);
  }
  return remainder;
}

}  // namespace echomap::boards
