// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace protocol {

/// Consistent overhead byte stuffing (Cheshire and Baker 1999) for blocks of at most 253 bytes, so
/// that one leading code byte is the whole overhead and no block needs a second one.

/// Stuffs `size` bytes that stand at `block + 1` in place and writes the leading code at `block`;
/// afterwards `block[0 .. size]` holds no zero. `size` is at most 253.
void cobs_encode_in_place(uint8_t* block, uint8_t size);

/// What one received byte meant to the unstuffing.
enum class CobsStatus : uint8_t {
  kNothing,    ///< A code byte: no data yet.
  kData,       ///< `value` is the next byte of the block.
  kEnd,        ///< The delimiter at the end of a whole block.
  kTruncated,  ///< The delimiter came before the code byte's run was over.
};

/// Unstuffs a stream byte by byte; a delimiter (0x00) always brings it back to the start.
class CobsDecoder {
 public:
  /// Takes one received byte; writes `value` only when the answer is kData.
  CobsStatus take(uint8_t byte, uint8_t& value);

 private:
  uint8_t left_in_run_ = 0;
  bool zero_follows_ = false;
};

}  // namespace protocol
}  // namespace echomap
