// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "host/fleet_messages/conversions.hpp"

namespace echomap::fleet {

/// Identity of a robot in its fleet, and how often it publishes what. Times are seconds of the
/// clock that the caller passes in. Values without a source are ours; docs/fleet_protocol.md
/// justifies them.
struct FleetExchangeParams {
  std::string fleet;
  std::string robot;
  /// Must grow with each start of this robot's host, as seconds since 1970 do.
  std::uint32_t boot_id = 1;
  fleet_messages::RobotTraits traits;
  /// Folder that stores the robot's own objects and graphs for its next start; empty: memory only.
  std::filesystem::path folder;

  double bytes_per_s = 950.0;   ///< Mean rate of MQTT packets sent.
  double burst_bytes = 4000.0;  ///< Largest burst above that rate.
  double presence_period_s = 5.0;
  double gone_after_s = 16.0;      ///< Silence that means gone: three heartbeats and a delay.
  double pose_period_s = 1.0;      ///< Shortest period of the poses of a robot that moves.
  double pose_moved_m = 0.02;      ///< Smallest change of position that counts as a move,
  double pose_moved_rad = 0.05;    ///< and of heading.
  double pose_repeat_s = 10.0;     ///< Period of the poses of a robot at rest.
  double compare_after_s = 5.0;    ///< After a connection: retained messages have come by then.
  double confirm_within_s = 20.0;  ///< What has not come back by then is sent again.
  double request_after_s = 8.0;    ///< From noticing that something is missing to its request.
  double request_period_s = 10.0;  ///< Between requests to one robot; grows without answers.
  double answer_period_s = 10.0;   ///< Shortest period of repeating one object.
  double relay_step_s = 3.0;       ///< Delay between robots that could relay the same.
};

/// Throws std::invalid_argument for an invalid name or a value outside of its range.
void validate(const FleetExchangeParams& params);

}  // namespace echomap::fleet
