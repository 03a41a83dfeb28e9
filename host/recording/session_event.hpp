// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "host/geometry/pose2.hpp"

namespace echomap::recording {

/// What happens in a session beside the frames of the robot, and moves its maps. Together with the
/// frames that were used, the events are all that a replay needs.
enum class SessionEventKind : std::uint8_t {
  kBeginSession,  ///< A session begins, behind those that it has resumed.
  kLinkReady,     ///< The handshake is done; `value` is the minor version of the robot's protocol.
  kRobotReset,    ///< The robot's counters start again; `value` microseconds passed since odometry.
  kBeginScan,     ///< Readings from here on are one scan.
  kEndScan,       ///< The scan is over.
  kPoseFix,       ///< A camera knew the pose at the robot's time `value`, microseconds.
  kBeginNewMap,   ///< The map is set aside; `value` stops were made elsewhere.
  kJoinMaps,      ///< The robot looks for the current map in those set aside.
  kEndMaps,       ///< The maps take nothing from here on.
};

/// One event of a session.
struct SessionEvent {
  SessionEventKind kind = SessionEventKind::kBeginSession;
  std::int64_t value = 0;         ///< What it means depends on the kind.
  geometry::Pose2 T_map_robot{};  ///< The pose of a kPoseFix.
};

/// The name of a kind in the recording, as "begin-scan".
std::string_view name_of(SessionEventKind kind);

/// The kind with this name; empty where there is none.
std::optional<SessionEventKind> event_kind(std::string_view name);

}  // namespace echomap::recording
