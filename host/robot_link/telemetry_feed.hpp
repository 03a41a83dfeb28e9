// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "host/robot_link/link_statistics.hpp"
#include "host/robot_link/robot_counters.hpp"
#include "host/robot_link/robot_link_listener.hpp"
#include "host/robot_link/robot_link_params.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap::robot_link {

/// Hands telemetry to the listener, and finds out where it stems from another start of the robot.
class TelemetryFeed {
 public:
  /// A step back of the stamps by more than `max_step_back` tells of a reset. `listener` outlives
  /// the feed.
  TelemetryFeed(RobotLinkListener& listener, RobotLinkParams::Duration max_step_back)
      : listener_(listener), max_step_back_(max_step_back) {}

  /// The next stamp may be any.
  void restart() { newest_stamp_us_.reset(); }
  /// What the board can count, as HelloReply tells it.
  void take_capabilities(std::uint32_t capabilities) { counters_.take_capabilities(capabilities); }
  /// The robot was reset, and its counters start at zero.
  void restart_counters() { counters_.restart(); }
  /// Since then; empty before the first.
  std::optional<std::uint32_t> newest_stamp_us() const { return newest_stamp_us_; }
  /// Whether what bears this stamp is from the same start of the robot as what came before.
  bool continues(std::uint32_t stamp_us);

  void deliver(const protocol::Odometry& message) { listener_.on_odometry(message); }
  void deliver(const protocol::Echo& message) { listener_.on_echo(message); }
  void deliver(const protocol::Status& message) { listener_.on_status(message); }
  void deliver(const protocol::Ranges& message) { listener_.on_ranges(message); }
  void deliver(const protocol::Gyro& message) { listener_.on_gyro(message); }
  void deliver(const protocol::Scalar& message) { listener_.on_scalar(message); }
  void deliver(const protocol::Health& message);
  void deliver(const protocol::EncoderErrors& message);

  /// Fills in what the robot said in Health of its own counters.
  void add_to(LinkStatistics& statistics) const { counters_.add_to(statistics); }

 private:
  RobotLinkListener& listener_;
  RobotLinkParams::Duration max_step_back_;
  std::optional<std::uint32_t> newest_stamp_us_;
  RobotCounters counters_;
};

}  // namespace echomap::robot_link
