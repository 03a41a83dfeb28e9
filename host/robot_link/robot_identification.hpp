// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/robot_link/bulk_reader.hpp"
#include "host/robot_link/protocol_mismatch.hpp"
#include "host/robot_link/robot_schema.hpp"
#include "protocol/handshake_messages.hpp"

namespace echomap::robot_link {

/// What a robot turns out to be.
enum class RobotIdentity : std::uint8_t {
  kUnderstood,   ///< All messages that are needed are the same.
  kUndescribed,  ///< It was built from other messages and must say which.
  kRefused,      ///< `mismatch()` says why.
};

/// Who is at the other end, from what it says of itself: whether it is the robot of the last
/// handshake, and which messages both sides understand.
class RobotIdentification {
 public:
  /// Only a robot with all of `needed_messages` is understood.
  explicit RobotIdentification(std::vector<std::uint8_t> needed_messages)
      : needed_messages_(std::move(needed_messages)) {}

  /// Whether the robot was reset since its last reply.
  bool is_another_start(const protocol::HelloReply& reply) const {
    return robot_ && robot_->boot_id != reply.boot_id;
  }
  void note(const protocol::HelloReply& reply) { robot_ = reply; }

  /// Judges by a reply alone, and by an earlier description of the same messages.
  RobotIdentity identify(const protocol::HelloReply& robot);
  /// Judges the robot of this reply by its description.
  RobotIdentity identify(const protocol::HelloReply& robot, const BulkResult& description);

  /// Whether both sides mean the same message by this id.
  bool understands(std::uint8_t message_id) const {
    return !difference_ || difference_->agrees(message_id);
  }

  /// The last reply; empty before the first.
  const std::optional<protocol::HelloReply>& robot() const { return robot_; }
  /// Empty where the messages do not differ.
  const std::optional<SchemaDifference>& difference() const { return difference_; }
  /// Of the robot that was refused last.
  const std::optional<ProtocolMismatch>& mismatch() const { return mismatch_; }

 private:
  RobotIdentity refuse(const protocol::HelloReply& robot, const std::string& difference);

  std::vector<std::uint8_t> needed_messages_;
  std::optional<protocol::HelloReply> robot_;
  std::optional<ProtocolMismatch> mismatch_;
  std::optional<SchemaDifference> difference_;
  std::uint32_t described_digest_ = 0;  ///< Of the messages that `difference_` tells of.
};

}  // namespace echomap::robot_link
