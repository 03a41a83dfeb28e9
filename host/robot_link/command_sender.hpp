// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "host/robot_link/command.hpp"
#include "host/robot_link/retransmission_timer.hpp"
#include "host/time/host_time.hpp"
#include "protocol/handshake_messages.hpp"

namespace echomap::robot_link {

/// Stop and wait: one command is on its way, the others queue behind it. A resent command keeps its
/// id, and the robot does each id once, so every command is done exactly once or ends in an outcome
/// that says otherwise.
class CommandSender {
 public:
  /// A command is given up after `max_tries` sends.
  CommandSender(const RetransmissionParams& retransmission, int max_tries);

  /// Queues `command` behind all others.
  CommandTicket submit(const Command& command);

  /// Whether a command must be sent now, for the first time or again.
  bool is_due(time::HostTime now) const;
  /// That command; only while `is_due`.
  const Command& take(time::HostTime now);
  /// That command without sending it; only while `is_due`.
  const Command& next() const { return queue_.front().command; }
  /// Ends that command unsent.
  CommandResult drop_next(CommandOutcome outcome) { return finish(outcome); }

  /// True when the last try went unanswered.
  bool is_exhausted(time::HostTime now) const;

  /// The robot's answer; empty where it belongs to no command on its way (a repeated answer).
  std::optional<CommandResult> acknowledge(const protocol::Ack& ack, time::HostTime now);

  /// Ends every command with `outcome`.
  std::vector<CommandResult> abandon(CommandOutcome outcome);

  std::uint64_t resent() const { return resent_; }
  const RetransmissionTimer& timer() const { return timer_; }

 private:
  struct Entry {
    CommandTicket ticket{};
    Command command;
  };

  CommandResult finish(CommandOutcome outcome);

  RetransmissionTimer timer_;
  int max_tries_;
  std::deque<Entry> queue_;  ///< The front is on its way when `tries_` > 0.
  int tries_ = 0;
  time::HostTime sent_at_;
  time::HostTime resend_at_;
  std::uint8_t last_id_ = 0;
  std::uint64_t last_ticket_ = 0;
  std::uint64_t resent_ = 0;
};

}  // namespace echomap::robot_link
