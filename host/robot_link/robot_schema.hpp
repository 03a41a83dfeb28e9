// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "protocol/message_schema.hpp"

namespace echomap::robot_link {

/// One message as a firmware describes it.
struct DescribedMessage {
  std::uint8_t id = 0;
  std::string name;
  protocol::Schema schema{};  ///< Seed and length, from its name and fields.
};

/// The messages that a firmware was built with, as it tells in BulkContent::kSchema; empty for a
/// description that is none.
std::optional<std::vector<DescribedMessage>> read_robot_schema(
    std::span<const std::uint8_t> description);

/// The digest of these messages, as HelloReply tells it.
std::uint32_t digest_of(const std::vector<DescribedMessage>& messages);

/// In what the messages of a robot and of this host differ.
class SchemaDifference {
 public:
  explicit SchemaDifference(const std::vector<DescribedMessage>& robot);

  /// Whether both sides mean the same message by this id.
  bool agrees(std::uint8_t id) const;
  /// What the robot means by an id of its own that this host reads otherwise or not at all; empty
  /// where they agree or the robot has none.
  std::optional<protocol::Schema> foreign(std::uint8_t id) const;

  /// Names of the messages that differ, and of those that only one side has.
  const std::vector<std::string>& different() const { return different_; }
  const std::vector<std::string>& missing_on_robot() const { return missing_on_robot_; }
  const std::vector<std::string>& unknown_to_host() const { return unknown_to_host_; }
  /// All of that in a sentence's part: "StartSweep differs; the robot lacks Ranges, Gyro".
  std::string summary() const;

 private:
  std::vector<std::uint8_t> agreed_;
  std::vector<DescribedMessage> foreign_;
  std::vector<std::string> different_;
  std::vector<std::string> missing_on_robot_;
  std::vector<std::string> unknown_to_host_;
};

}  // namespace echomap::robot_link
