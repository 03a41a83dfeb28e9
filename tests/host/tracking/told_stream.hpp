// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include "host/transport/byte_stream.hpp"

namespace echomap::tests {

/// Bytes that a test has told it, at most seven at a time.
class ToldStream final : public transport::ByteStream {
 public:
  explicit ToldStream(std::string& bytes) : bytes_(bytes) {}

  std::size_t read_some(std::span<std::uint8_t> into, std::chrono::microseconds /*wait*/) override {
    const std::size_t count = std::min({into.size(), bytes_.size(), std::size_t{7}});
    std::copy_n(bytes_.begin(), count, into.begin());
    bytes_.erase(0, count);
    return count;
  }
  void write(std::span<const std::uint8_t> /*bytes*/) override {}
  transport::StreamStatus status() const override { return transport::StreamStatus::kOpen; }
  std::string close_reason() const override { return {}; }
  std::string name() const override { return "udp://camera"; }

 private:
  std::string& bytes_;
};

}  // namespace echomap::tests
