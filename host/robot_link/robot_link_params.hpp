// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "host/robot_link/bulk_reader.hpp"
#include "host/robot_link/credit_window.hpp"
#include "host/robot_link/ping_sender.hpp"
#include "host/robot_link/protocol_mismatch.hpp"
#include "host/robot_link/retransmission_timer.hpp"
#include "host/time/clock_sync.hpp"
#include "host/time/host_time.hpp"

namespace echomap::robot_link {

/// Times of the link, in docs/protocol.md; the robot's side is built for these.
struct RobotLinkParams {
  using Duration = time::HostClock::duration;
  Duration hello_period = std::chrono::milliseconds(50);
  Duration keep_alive_period = std::chrono::milliseconds(50);
  Duration keep_alive_ttl = std::chrono::milliseconds(200);  ///< How long motion outlives us.
  Duration quiet_after = std::chrono::milliseconds(300);     ///< Status comes every 200 ms: ask.
  Duration lost_after = std::chrono::seconds(1);             ///< No frame on a ready link.
  Duration diagnose_after = std::chrono::seconds(2);         ///< Hello has found no answer.
  /// Telemetry that is older than what came before by more than this is from after a reset.
  Duration max_step_back = std::chrono::milliseconds(200);
  PingParams ping{};
  time::ClockSyncParams clock{};
  RetransmissionParams retransmission{};
  CreditParams credit{};
  BulkParams bulk{};
  /// A robot that another session holds is taken over, once, instead of waited for.
  bool takes_over = false;
  /// A robot built from other messages is still spoken to as long as these are the same.
  std::vector<std::uint8_t> needed_messages = messages_for_mapping();
  /// At 5 % frame loss each way a try fails at 9.75 %: five in a row once in 110,000 commands,
  /// eight once in 120 million.
  int command_tries = 8;
};

/// For a wire of this speed in bits per second; the default is one of 115200 baud.
RobotLinkParams wired_link(int baud);

/// For Bluetooth SPP: commands are sent again later, and what moves outlives two of the 150 ms for
/// which the radio now and then holds bytes back. Its delays are random, so all that arrives tells
/// of the clock.
RobotLinkParams radio_link();

/// The same; throws std::invalid_argument where the periods do not fit together.
RobotLinkParams validated(const RobotLinkParams& params);

}  // namespace echomap::robot_link
