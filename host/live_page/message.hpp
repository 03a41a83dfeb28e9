// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace echomap::live_page {

/// What a message of echomap.v1 is (docs/live_protocol.md).
enum class MessageKind : std::uint8_t {
  kHello = 1,
  kTile = 2,
  kMotion = 3,
  kParticles = 4,
  kTrail = 5,
  kRoom = 6,
  kState = 7,
  kEvent = 8,
  kNewMap = 9,
  kTeam = 10,
};

/// One message as it goes over the line.
struct Message {
  MessageKind kind = MessageKind::kEvent;
  /// Of two messages with the same kind and key the later one replaces the earlier one, but for
  /// events and new maps: a tile's place, else 0.
  std::uint64_t key = 0;
  double time_s = 0.0;  ///< Of the run.
  std::string bytes;    ///< Header and body.

  bool is_state() const { return kind != MessageKind::kEvent && kind != MessageKind::kNewMap; }
};

/// Encoded once, sent to every client.
using SharedMessage = std::shared_ptr<const Message>;

}  // namespace echomap::live_page
