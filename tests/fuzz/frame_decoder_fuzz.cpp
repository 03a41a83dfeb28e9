// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "protocol/frame_decoder.hpp"
#include "protocol/message_codec.hpp"
#include "protocol/messages.hpp"
#include "tests/fuzz/frames.hpp"

namespace protocol = echomap::protocol;

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() { return golden_frames(); }

/// One input is a byte stream as it comes from the line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  protocol::FrameDecoder decoder(protocol::AllMessages::find_schema);
  for (std::size_t i = 0; i < size; ++i) {
    if (decoder.take(data[i]) == protocol::DecodeStatus::kFrame) {
      const protocol::Frame frame = decoder.frame();
      echomap::fuzz::EncodeAgain encode_again{{frame.payload, frame.payload_size}};
      if (!protocol::Dispatcher<protocol::AllMessages>::dispatch(
              frame.id, frame.payload, encode_again)) {
        std::abort();
      }
    }
  }
  return 0;
}
