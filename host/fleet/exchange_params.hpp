// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "host/fleet_messages/conversions.hpp"

namespace echomap::fleet {

/// Who takes part in which fleet, and how often it says what. Times are seconds of the clock that
/// the caller passes in. Values without a source are ours; docs/fleet_protocol.md justifies them.
struct FleetExchangeParams {
  std::string fleet;
  std::string robot;
  /// Larger after each start of this robot's host, as seconds since 1970 are.
  std::uint32_t boot_id = 1;
  fleet_messages::RobotTraits traits;
  /// Where own objects and graphs are kept for the next start; empty: in memory only.
  std::filesystem::path folder;

  double bytes_per_s = 950.0;   ///< Of MQTT packets sent, in the mean.
  double burst_bytes = 4000.0;  ///< And some more at once.
  double presence_period_s = 5.0;
  double gone_after_s = 16.0;      ///< Without a message: three heartbeats and a delay are missing.
  double pose_period_s = 1.0;      ///< At most so often, where the robot has moved by
  double pose_moved_m = 0.02;      ///< so much
  double pose_moved_rad = 0.05;    ///< or that.
  double pose_repeat_s = 10.0;     ///< So often where it has not.
  double compare_after_s = 5.0;    ///< Since a connection: what the broker had has come by then.
  double confirm_within_s = 20.0;  ///< Since it was sent: what was not heard back is sent again.
  double ask_after_s = 8.0;        ///< Since it was missed first.
  double ask_period_s = 10.0;      ///< Of one robot.
  double answer_period_s = 10.0;   ///< An object is sent again at most so often.
  double relay_step_s = 3.0;       ///< Between those that could relay the same.
};

/// Throws std::invalid_argument for an invalid name or a value outside of its range.
void validate(const FleetExchangeParams& params);

}  // namespace echomap::fleet
