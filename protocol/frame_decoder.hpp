// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/cobs.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/message_schema.hpp"

namespace echomap {
namespace protocol {

/// A frame that passed every check; `payload` points into the decoder and holds until its next
/// byte.
struct Frame {
  uint8_t id;
  uint8_t seq;
  const uint8_t* payload;
  uint8_t payload_size;
};

/// What one received byte completed.
enum class DecodeStatus : uint8_t {
  kIncomplete,   ///< In the middle of a frame, or an empty one (delimiters in a row).
  kFrame,        ///< `frame()` is whole and right.
  kTooLong,      ///< More bytes than any frame has: dropped up to the delimiter.
  kTruncated,    ///< The delimiter came inside a COBS run, or before id, seq and CRC were there.
  kUnknownId,    ///< Not an id of this receiver's list.
  kWrongLength,  ///< The payload does not have the length of its id.
  kBadCrc,       ///< Damaged, or another schema of the same id.
};

/// Looks up what the receiver knows of an id; see MessageList::find_schema.
using FindSchema = Schema (*)(uint8_t id);

/// Takes a byte stream apart into checked frames. One damaged frame costs at most itself and its
/// neighbour (when the delimiter between them was lost); nothing is allocated and nothing waits.
class FrameDecoder {
 public:
  constexpr explicit FrameDecoder(FindSchema find_schema) : find_schema_(find_schema) {}

  /// Takes one byte. After kFrame, `frame()` is valid until the next call.
  DecodeStatus take(uint8_t byte);
  Frame frame() const;

  /// True for the statuses that mean a lost frame.
  static bool is_error(DecodeStatus status) { return status > DecodeStatus::kFrame; }

 private:
  static constexpr uint8_t kHeaderSize = 2;
  static constexpr uint8_t kCrcSize = 2;
  static constexpr uint8_t kMaxBlock = kHeaderSize + kMaxPayload + kCrcSize;

  DecodeStatus check(bool whole) const;
  uint8_t payload_size() const { return static_cast<uint8_t>(size_ - kHeaderSize - kCrcSize); }

  FindSchema find_schema_;
  CobsDecoder cobs_;
  uint8_t block_[kMaxBlock] = {};
  uint8_t size_ = 0;
  bool started_ = false;
  bool ended_ = false;
  bool too_long_ = false;
};

}  // namespace protocol
}  // namespace echomap
