// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "host/time/host_time.hpp"
#include "protocol/command_messages.hpp"

namespace echomap::robot_link {

/// The latest set-point while it waits for credit: a newer one replaces it, and it waits for no
/// longer than the robot would follow it.
class SetpointSlot {
 public:
  void put(const protocol::DriveSetpoint& setpoint, time::HostTime now);
  /// Drops a set-point that has outlived itself.
  void drop_expired(time::HostTime now);
  bool is_waiting() const { return waiting_.has_value(); }
  /// The set-point, which waits no longer; empty where none does.
  std::optional<protocol::DriveSetpoint> take();

  /// Set-points that a newer one replaced or that grew too old.
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct Waiting {
    protocol::DriveSetpoint setpoint;
    time::HostTime since;
  };

  std::optional<Waiting> waiting_;
  std::uint64_t dropped_ = 0;
};

}  // namespace echomap::robot_link
