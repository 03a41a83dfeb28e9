// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/frame_decoder.hpp"
#include "protocol/messages.hpp"

namespace echomap {
namespace protocol {

/// Counts what a receiver lost. Counters wrap at 2^16; the first frame after `restart` sets the
/// sequence.
class ReceiveCounters {
 public:
  /// Takes every decoder status; `seq` counts only with kFrame.
  void take(DecodeStatus status, uint8_t seq);

  /// The peer starts a new sequence (reset, reconnect): a jump is no loss.
  void restart() { synchronised_ = false; }

  uint16_t frames_good() const { return frames_good_; }
  uint16_t frames_bad() const { return frames_bad_; }
  /// Frames whose sequence numbers never arrived whole, damaged ones included.
  uint16_t frames_lost() const { return frames_lost_; }

 private:
  uint16_t frames_good_ = 0;
  uint16_t frames_bad_ = 0;
  uint16_t frames_lost_ = 0;
  uint8_t expected_seq_ = 0;
  bool synchronised_ = false;
};

/// The robot's memory of the session that holds it, and of its last command, so that a resent one
/// is acknowledged again but not done again. Command ids 1 .. 255 go round; 0 is no command.
class CommandFilter {
 public:
  /// For how long a session holds the robot without a word. A host pings once a second, so that one
  /// lost ping costs nobody the robot; one that comes back after a crash waits no longer than this.
  static constexpr uint16_t kHoldMs = 2500;

  /// A Hello with a new session forgets the last command; true when the session is new. The session
  /// holds the robot from now on.
  bool begin_session(uint16_t session);

  /// The session of the last Hello that was not refused; 0 before the first.
  uint16_t session() const { return session_; }
  /// True when another session holds the robot than the one whose Hello came.
  bool refuses(uint16_t session) const { return held_ms_ != 0 && session != session_; }
  /// A whole frame came that was not refused: the session is alive.
  void hear() { held_ms_ = holds_ ? kHoldMs : uint16_t{0}; }
  /// The session keeps the robot, or gives it up to whoever says Hello next.
  void hold(bool on) {
    holds_ = on;
    hear();
  }
  /// So much time has passed.
  void pass(uint8_t ms) {
    held_ms_ = held_ms_ > ms ? static_cast<uint16_t>(held_ms_ - ms) : uint16_t{0};
  }

  /// True when `command_id` was already answered: send `answer()` again and do nothing else.
  bool is_repeat(uint8_t command_id) const { return command_id == last_id_ && last_id_ != 0; }

  /// Remembers how a command was answered.
  void remember(uint8_t command_id, CommandStatus status);

  /// The answer to the last command.
  Ack answer() const { return Ack{last_id_, static_cast<uint8_t>(last_status_)}; }

 private:
  uint16_t session_ = 0;
  uint16_t held_ms_ = 0;  ///< What is left of the hold.
  uint8_t last_id_ = 0;
  CommandStatus last_status_ = CommandStatus::kAccepted;
  bool has_session_ = false;
  bool holds_ = false;
};

/// The id after `command_id`: 1 .. 255, then 1 again.
inline uint8_t next_command_id(uint8_t command_id) {
  return command_id == 255 ? 1 : static_cast<uint8_t>(command_id + 1);
}

}  // namespace protocol
}  // namespace echomap
