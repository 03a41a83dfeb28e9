// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "protocol/frame_decoder.hpp"
#include "protocol/message_codec.hpp"
#include "protocol/messages.hpp"
#include "tests/fuzz/frames.hpp"

namespace {

namespace protocol = echomap::protocol;

/// Encodes each message that was decoded again: it must give the payload that it came from.
struct EncodeAgain {
  const protocol::Frame& frame;
  template <class M>
  void operator()(const M& message) {
    std::vector<std::uint8_t> payload(protocol::MessageFacts<M>::kSize);
    put_payload(message, payload.data());
    if (payload != std::vector<std::uint8_t>(frame.payload, frame.payload + frame.payload_size)) {
      std::abort();
    }
  }
};

}  // namespace

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() { return golden_frames(); }

/// One input is a byte stream as it comes from the line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  protocol::FrameDecoder decoder(protocol::AllMessages::find_schema);
  for (std::size_t i = 0; i < size; ++i) {
    if (decoder.take(data[i]) == protocol::DecodeStatus::kFrame) {
      const protocol::Frame frame = decoder.frame();
      EncodeAgain encode_again{frame};
      if (!protocol::Dispatcher<protocol::AllMessages>::dispatch(
              frame.id, frame.payload, encode_again)) {
        std::abort();
      }
    }
  }
  return 0;
}
