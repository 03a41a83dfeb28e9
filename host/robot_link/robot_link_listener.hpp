// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "host/robot_link/bulk_reader.hpp"
#include "host/robot_link/command.hpp"
#include "protocol/handshake_messages.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap::robot_link {

/// Receives what RobotLink decodes, in order of arrival, from within `receive` and `poll`.
/// Telemetry comes only while the link is ready, so never from before a reset that was not
/// announced. A handler may submit commands; it must not call `receive` or `poll`.
class RobotLinkListener {
 public:
  virtual ~RobotLinkListener() = default;

  virtual void on_odometry(const protocol::Odometry& /*message*/) {}
  virtual void on_echo(const protocol::Echo& /*message*/) {}
  virtual void on_status(const protocol::Status& /*message*/) {}
  virtual void on_health(const protocol::Health& /*message*/) {}
  virtual void on_ranges(const protocol::Ranges& /*message*/) {}
  virtual void on_gyro(const protocol::Gyro& /*message*/) {}
  virtual void on_encoder_errors(const protocol::EncoderErrors& /*message*/) {}
  virtual void on_scalar(const protocol::Scalar& /*message*/) {}

  /// What `RobotLink::read` asked for.
  virtual void on_bulk(const BulkResult& /*result*/) {}

  /// The handshake is done, for the first time or again.
  virtual void on_ready(const protocol::HelloReply& /*reply*/) {}
  /// The robot started anew since the last handshake: disarmed, counters and clock at zero.
  /// `reset_cause` is a set of protocol::ResetCause bits. Pending commands have ended before.
  virtual void on_reset(std::uint8_t /*reset_cause*/) {}
  virtual void on_command_done(const CommandResult& /*result*/) {}
};

}  // namespace echomap::robot_link
