// SPDX-License-Identifier: MIT
#include "protocol/cobs.hpp"

namespace echomap {
namespace protocol {

void cobs_encode_in_place(uint8_t* block, uint8_t size) {
  uint8_t* code = block;
  uint8_t distance = 1;
  for (uint8_t* byte = block + 1; byte != block + 1 + size; ++byte) {
    if (*byte == 0) {
      *code = distance;
      code = byte;
      distance = 0;
    }
    ++distance;
  }
  *code = distance;
}

CobsStatus CobsDecoder::take(uint8_t byte, uint8_t& value) {
  if (byte == 0) {
    const bool whole = left_in_run_ == 0;
    left_in_run_ = 0;
    zero_follows_ = false;
    return whole ? CobsStatus::kEnd : CobsStatus::kTruncated;
  }
  if (left_in_run_ > 0) {
    --left_in_run_;
    value = byte;
    return CobsStatus::kData;
  }
  const bool owed_zero = zero_follows_;
  left_in_run_ = static_cast<uint8_t>(byte - 1);
  zero_follows_ = byte != 0xFF;
  if (!owed_zero) {
    return CobsStatus::kNothing;
  }
  value = 0;
  return CobsStatus::kData;
}

}  // namespace protocol
}  // namespace echomap
