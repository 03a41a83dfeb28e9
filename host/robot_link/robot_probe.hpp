// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/robot_link/byte_preview.hpp"
#include "protocol/frame_decoder.hpp"
#include "protocol/handshake_messages.hpp"

namespace echomap::robot_link {

/// Finds out what is at the other end of a port, which may be anything: a robot, a modem, a
/// printer. It says Hello once, which no other device is harmed by, and listens. Bytes in, bytes
/// out; it owns no port and no clock.
class RobotProbe {
 public:
  /// `session` is that of the RobotLink which takes over when a robot answers.
  explicit RobotProbe(std::uint16_t session);

  /// The one Hello, after a delimiter.
  std::vector<std::uint8_t> hello() const;
  void receive(std::span<const std::uint8_t> bytes);

  /// The robot's word, to this Hello or of its own after a reset; empty while none came.
  const std::optional<protocol::HelloReply>& robot() const { return robot_; }
  /// Whether a whole frame has come, of whatever kind: it is a robot that speaks at this speed.
  bool hears_frames() const { return hears_frames_; }
  /// Whether a robot's reply with this session says that another program holds it. One that has
  /// just started says 0.
  bool is_foreign(std::uint16_t session) const { return session != 0 && session != session_; }
  /// What came that was no frame.
  const BytePreview& preview() const { return preview_; }

 private:
  std::uint16_t session_;
  protocol::FrameDecoder decoder_;
  BytePreview preview_;
  std::optional<protocol::HelloReply> robot_;
  bool hears_frames_ = false;
};

}  // namespace echomap::robot_link
