// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "protocol/handshake_messages.hpp"

namespace echomap::robot_link {

/// Which of the two is older, judged by protocol versions.
enum class SideToUpdate : std::uint8_t {
  kFirmware,  ///< Also where versions are equal and only the messages differ.
  kHost,
};

/// What both sides said of themselves when their messages differ.
struct ProtocolMismatch {
  std::uint8_t host_major = 0;
  std::uint8_t host_minor = 0;
  std::uint32_t host_digest = 0;
  std::uint8_t robot_major = 0;
  std::uint8_t robot_minor = 0;
  std::uint32_t robot_digest = 0;
  std::uint16_t robot_firmware_version = 0;  ///< See protocol::kFirmwareVersion.
  /// In which messages they differ, in words; empty where the robot did not tell.
  std::string difference;

  SideToUpdate side_to_update() const;
  /// Both versions, in what they differ, and the command that updates the older side.
  std::string message() const;

 private:
  std::string next_step() const;
};

/// True when the robot was built from the same messages as this host.
bool speaks_our_protocol(const protocol::HelloReply& reply);

/// The messages without which no robot can be driven through a room and heard.
std::vector<std::uint8_t> messages_for_mapping();

/// Both sides' versions, for a reply that does not match.
ProtocolMismatch mismatch_with(const protocol::HelloReply& reply);

}  // namespace echomap::robot_link
