// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace echomap::live_page {

/// Of what a frame tells: kind and key.
using FrameChannel = std::pair<std::uint64_t, std::uint64_t>;

/// One WebSocket frame on its way to a client. Its bytes are shared by all that get them.
struct Frame {
  std::shared_ptr<const std::string> bytes;
  bool is_text = false;
  /// Of two waiting frames of one channel only the later one is sent. Nothing: none is left out.
  std::optional<FrameChannel> channel;
};

/// A text that is never left out.
inline Frame text_frame(std::string text) {
  return {std::make_shared<const std::string>(std::move(text)), true, {}};
}

}  // namespace echomap::live_page
