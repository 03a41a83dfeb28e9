// SPDX-License-Identifier: MIT
#include "protocol/frame_encoder.hpp"

#include <string.h>

#include "protocol/cobs.hpp"
#include "protocol/crc16.hpp"

namespace echomap {
namespace protocol {

ByteSpan FrameEncoder::encode(
    const uint8_t* payload, uint8_t id, uint8_t size, uint16_t seed, uint8_t seq) {
  uint8_t* block = buffer_ + 1;
  block[0] = id;
  block[1] = seq;
  memcpy(block + kHeaderSize, payload, size);
  size = static_cast<uint8_t>(size + kHeaderSize);
  const uint16_t crc = crc16(block, size, seed);
  block[size++] = static_cast<uint8_t>(crc);
  block[size++] = static_cast<uint8_t>(crc >> 8);
  cobs_encode_in_place(buffer_, size);
  buffer_[size + 1] = 0;
  return ByteSpan{buffer_, static_cast<uint8_t>(size + 2)};
}

}  // namespace protocol
}  // namespace echomap
