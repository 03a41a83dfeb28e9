// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "hil_mock/runner/byte_endpoint.hpp"
#include "hil_mock/runner/wait_readable.hpp"

namespace echomap::runner {

/// `count` bytes, or fewer after five seconds.
inline std::string receive_all(ByteEndpoint& endpoint, std::size_t count) {
  std::string bytes;
  for (int i = 0; i < 100 && bytes.size() < count; ++i) {
    wait_readable(endpoint, -1, std::chrono::milliseconds(50));
    for (const std::uint8_t byte : endpoint.receive()) {
      bytes.push_back(static_cast<char>(byte));
    }
  }
  return bytes;
}

/// The bytes of a text.
inline void send_text(ByteEndpoint& endpoint, const std::string& text) {
  endpoint.send(std::vector<std::uint8_t>(text.begin(), text.end()));
}

}  // namespace echomap::runner
