// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <zlib.h>

namespace echomap::mcap {

/// CRC-32 (polynomial 0xEDB88320 reflected, as in zip) of `bytes` that follow bytes whose CRC-32 is
/// `crc_before`; 0 stands for no bytes before.
inline std::uint32_t crc32_of(std::span<const std::uint8_t> bytes, std::uint32_t crc_before = 0) {
  return static_cast<std::uint32_t>(::crc32_z(crc_before, bytes.data(), bytes.size()));
}

}  // namespace echomap::mcap
