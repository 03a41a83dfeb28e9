// SPDX-License-Identifier: MIT
#include "host/robot_link/command_sender.hpp"

#include <stdexcept>

#include "protocol/link.hpp"

namespace echomap::robot_link {
namespace {

CommandOutcome outcome_of(std::uint8_t status) {
  switch (static_cast<protocol::CommandStatus>(status)) {
    case protocol::CommandStatus::kAccepted:
      return CommandOutcome::kAccepted;
    case protocol::CommandStatus::kDisarmed:
      return CommandOutcome::kDisarmed;
    case protocol::CommandStatus::kBusy:
      return CommandOutcome::kBusy;
    case protocol::CommandStatus::kOutOfRange:
      return CommandOutcome::kOutOfRange;
    case protocol::CommandStatus::kBlocked:
      return CommandOutcome::kBlocked;
  }
  return CommandOutcome::kRefused;
}

}  // namespace

CommandSender::CommandSender(const RetransmissionParams& retransmission, int max_tries)
    : timer_(retransmission), max_tries_(max_tries) {
  if (max_tries < 1) {
    throw std::invalid_argument("command sender: max_tries must be at least 1");
  }
}

CommandTicket CommandSender::submit(const Command& command) {
  const CommandTicket ticket{++last_ticket_};
  queue_.push_back({ticket, command});
  return ticket;
}

bool CommandSender::is_due(time::HostTime now) const {
  return !queue_.empty() && tries_ < max_tries_ && (tries_ == 0 || now >= resend_at_);
}

const Command& CommandSender::take(time::HostTime now) {
  if (tries_ == 0) {
    last_id_ = protocol::next_command_id(last_id_);
    std::visit([this](auto& message) { message.command_id = last_id_; }, queue_.front().command);
  } else {
    timer_.back_off();
    ++resent_;
  }
  ++tries_;
  sent_at_ = now;
  resend_at_ = now + timer_.timeout();
  return queue_.front().command;
}

bool CommandSender::is_exhausted(time::HostTime now) const {
  return tries_ == max_tries_ && now >= resend_at_;
}

std::optional<CommandResult> CommandSender::acknowledge(const protocol::Ack& ack,
                                                        time::HostTime now) {
  if (tries_ == 0 || ack.command_id != last_id_) {
    return std::nullopt;
  }
  if (tries_ == 1) {
    timer_.sample(now - sent_at_);
  }
  return finish(outcome_of(ack.status));
}

std::vector<CommandResult> CommandSender::abandon(CommandOutcome outcome) {
  std::vector<CommandResult> results;
  while (!queue_.empty()) {
    results.push_back(finish(outcome));
  }
  return results;
}

CommandResult CommandSender::finish(CommandOutcome outcome) {
  const std::uint8_t sent_id = tries_ > 0 ? last_id_ : std::uint8_t{0};
  const CommandResult result{queue_.front().ticket, sent_id, outcome};
  queue_.pop_front();
  tries_ = 0;
  return result;
}

}  // namespace echomap::robot_link
