// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "protocol/message_codec.hpp"
#include "protocol/messages.hpp"
#include "tests/fuzz/frames.hpp"

namespace protocol = echomap::protocol;

/// The id and payload of each golden frame.
std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  std::vector<Input> seeds;
  for (const Input& frame : golden_frames()) {
    protocol::FrameDecoder decoder(protocol::AllMessages::find_schema);
    for (const std::uint8_t byte : frame) {
      if (decoder.take(byte) == protocol::DecodeStatus::kFrame) {
        const protocol::Frame whole = decoder.frame();
        Input& seed = seeds.emplace_back(Input{whole.id});
        seed.insert(seed.end(), whole.payload, whole.payload + whole.payload_size);
      }
    }
  }
  return seeds;
}

/// One input is a message id and its payload, cut or filled with zeros to the length of the id; the
/// payload has a heap block of its own, so that nothing is read beyond it unseen.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  const protocol::Schema schema = protocol::AllMessages::find_schema(data[0]);
  if (!schema.known()) {
    return 0;
  }
  std::vector<std::uint8_t> payload(schema.payload_size);
  std::copy_n(data + 1, std::min(size - 1, payload.size()), payload.begin());
  echomap::fuzz::EncodeAgain encode_again{payload};
  if (!protocol::Dispatcher<protocol::AllMessages>::dispatch(
          data[0], payload.data(), encode_again)) {
    std::abort();
  }
  return 0;
}
