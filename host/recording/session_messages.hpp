// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/ros_messages/geometry_msgs.hpp"

namespace echomap::recording {

/// The topics of a session that a replay reads; all others show what the host made of these.
inline constexpr std::string_view kReceivedTopic = "/robot/frames_received";
inline constexpr std::string_view kSentTopic = "/robot/frames_sent";
inline constexpr std::string_view kEventTopic = "/session/events";

/// One frame on the line between host and robot (docs/protocol.md), or a run of bytes that is none.
/// The host's clock is the message's log time.
struct LineFrame {
  static constexpr std::string_view kName = "echomap_msgs/msg/LineFrame";
  bool is_used = false;              ///< The host took what it says for an observation.
  std::uint32_t robot_stamp_us = 0;  ///< The robot's clock, where it is used.
  std::vector<std::uint8_t> data{};  ///< As on the wire, the delimiter behind it included.

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("is_used", self.is_used);
    visit("robot_stamp_us", self.robot_stamp_us);
    visit("data", self.data);
  }
};

/// A SessionEvent as it is recorded.
struct SessionEventMessage {
  static constexpr std::string_view kName = "echomap_msgs/msg/SessionEvent";
  std::string kind{};
  std::int64_t value = 0;
  ros_messages::Pose2D pose{};

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("kind", self.kind);
    visit("value", self.value);
    visit("pose", self.pose);
  }
};

}  // namespace echomap::recording
