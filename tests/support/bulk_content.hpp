// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "protocol/bulk_messages.hpp"
#include "protocol/message_codec.hpp"

namespace echomap::tests {

/// The bytes that a BulkData brings.
inline std::vector<std::uint8_t> bytes_of(const protocol::BulkData& data) {
  std::vector<std::uint8_t> payload(protocol::MessageFacts<protocol::BulkData>::kSize);
  put_payload(data, payload.data());
  return {payload.end() - protocol::kBulkBytes, payload.end()};
}

/// A content put together from its pieces, in whatever order they come.
class BulkBuffer {
 public:
  void add(const protocol::BulkData& data) {
    bytes_.resize(data.total);
    const std::vector<std::uint8_t> piece = bytes_of(data);
    for (std::size_t i = 0; i < piece.size() && data.offset + i < bytes_.size(); ++i) {
      bytes_[data.offset + i] = piece[i];
    }
  }
  std::size_t total() const { return bytes_.size(); }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace echomap::tests
