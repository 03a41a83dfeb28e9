// SPDX-License-Identifier: MIT
#include "host/robot_link/foreign_frames.hpp"

#include "protocol/cobs.hpp"
#include "protocol/crc16.hpp"
#include "protocol/frame_encoder.hpp"

namespace echomap::robot_link {
namespace {

constexpr std::size_t kHeaderBytes = 2;
constexpr std::size_t kCrcBytes = 2;
/// The length of a payload is one byte in a schema.
constexpr std::size_t kMaxBytes = 255 + protocol::kFrameOverhead;

/// Empty for a block that is cut short.
std::vector<std::uint8_t> unstuffed(const std::vector<std::uint8_t>& stuffed) {
  protocol::CobsDecoder cobs;
  std::vector<std::uint8_t> block;
  std::uint8_t value = 0;
  for (const std::uint8_t byte : stuffed) {
    if (cobs.take(byte, value) == protocol::CobsStatus::kData) {
      block.push_back(value);
    }
  }
  const bool is_whole = cobs.take(0, value) == protocol::CobsStatus::kEnd;
  return is_whole ? block : std::vector<std::uint8_t>();
}

}  // namespace

void ForeignFrames::add(std::uint8_t byte) {
  if (ended_) {
    stuffed_.clear();
  }
  ended_ = byte == 0;
  if (!ended_ && stuffed_.size() < kMaxBytes) {
    stuffed_.push_back(byte);
  }
}

std::optional<std::uint8_t> ForeignFrames::recognised(const SchemaDifference& difference) const {
  const std::vector<std::uint8_t> block = unstuffed(stuffed_);
  if (!ended_ || block.size() < kHeaderBytes + kCrcBytes) {
    return std::nullopt;
  }
  const std::size_t covered = block.size() - kCrcBytes;
  const auto schema = difference.foreign(block[0]);
  if (!schema || covered - kHeaderBytes != schema->payload_size) {
    return std::nullopt;
  }
  const unsigned received = block[covered] | unsigned{block[covered + 1]} << 8U;
  const unsigned computed =
      protocol::crc16(block.data(), static_cast<std::uint8_t>(covered), schema->seed);
  return received == computed ? std::optional(block[1]) : std::nullopt;
}

}  // namespace echomap::robot_link
