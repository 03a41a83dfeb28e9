// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_probe.hpp"

#include <algorithm>

#include "protocol/frame_encoder.hpp"
#include "protocol/message_codec.hpp"
#include "protocol/messages.hpp"
#include "protocol/version.hpp"

namespace echomap::robot_link {

RobotProbe::RobotProbe(std::uint16_t session)
    : session_(session), decoder_(protocol::MessagesToHost::find_schema) {}

std::vector<std::uint8_t> RobotProbe::hello() const {
  // Just before the 0 with which a RobotLink begins, so that the robot misses nothing.
  constexpr std::uint8_t kSeq = 0xFF;
  protocol::FrameEncoder encoder;
  const protocol::ByteSpan frame = encoder.encode(
      protocol::Hello{
          protocol::kProtocolMajor, protocol::kProtocolMinor, protocol::kSchemaDigest, session_},
      kSeq);
  std::vector<std::uint8_t> bytes(1 + frame.size, 0);
  std::copy_n(frame.data, frame.size, bytes.begin() + 1);
  return bytes;
}

void RobotProbe::receive(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    preview_.add(byte);
    if (decoder_.take(byte) != protocol::DecodeStatus::kFrame) {
      continue;
    }
    preview_.clear();
    hears_frames_ = true;
    const protocol::Frame frame = decoder_.frame();
    if (frame.id == protocol::HelloReply::kId) {
      robot_ = protocol::get_payload<protocol::HelloReply>(frame.payload);
    }
  }
}

}  // namespace echomap::robot_link
