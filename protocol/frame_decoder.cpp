// SPDX-License-Identifier: MIT
#include "protocol/frame_decoder.hpp"

#include "protocol/crc16.hpp"

namespace echomap {
namespace protocol {

DecodeStatus FrameDecoder::take(uint8_t byte) {
  if (ended_) {
    size_ = 0;
    started_ = ended_ = too_long_ = false;
  }
  uint8_t value = 0;
  switch (cobs_.take(byte, value)) {
    case CobsStatus::kNothing:
      started_ = true;
      return DecodeStatus::kIncomplete;
    case CobsStatus::kData:
      if (size_ == kMaxBlock) {
        too_long_ = true;
      } else {
        block_[size_++] = value;
      }
      return DecodeStatus::kIncomplete;
    case CobsStatus::kEnd:
      ended_ = true;
      return check(true);
    case CobsStatus::kTruncated:
      ended_ = true;
      return check(false);
  }
  return DecodeStatus::kIncomplete;
}

Frame FrameDecoder::frame() const {
  return Frame{block_[0], block_[1], block_ + kHeaderSize, payload_size()};
}

DecodeStatus FrameDecoder::check(bool whole) const {
  if (!started_) {
    return DecodeStatus::kIncomplete;
  }
  if (too_long_) {
    return DecodeStatus::kTooLong;
  }
  if (!whole || size_ < kHeaderSize + kCrcSize) {
    return DecodeStatus::kTruncated;
  }
  const Schema schema = find_schema_(block_[0]);
  if (!schema.known()) {
    return DecodeStatus::kUnknownId;
  }
  if (payload_size() != schema.payload_size) {
    return DecodeStatus::kWrongLength;
  }
  const uint8_t covered = static_cast<uint8_t>(size_ - kCrcSize);
  const uint16_t received =
      static_cast<uint16_t>(block_[covered] | (static_cast<uint16_t>(block_[covered + 1]) << 8));
  const uint16_t computed = crc16(block_, covered, schema.seed);
  return received == computed ? DecodeStatus::kFrame : DecodeStatus::kBadCrc;
}

}  // namespace protocol
}  // namespace echomap
