// SPDX-License-Identifier: MIT
#include "host/live_page/command_handler.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

namespace echomap::live_page {

using nlohmann::ordered_json;

/// What became of a command.
struct CommandHandler::Taking {
  std::optional<Refusal> refusal;
  std::optional<session::OperatorCommand> command;
};

namespace {

/// Of a clock that was rounded on its way through a browser.
constexpr double kClockRoundingMs = 1.0;

bool is_stop(const session::OperatorCommand& command) {
  return std::holds_alternative<session::StopRobot>(command);
}

/// Whether the robot drives on by itself then.
bool drives_by_itself(const session::OperatorCommand& command) {
  return std::holds_alternative<session::ResumeStrategy>(command) ||
         std::holds_alternative<session::GoTo>(command);
}

std::string answer_text(const ClientCommand& command,
                        const std::optional<Refusal>& refusal,
                        double now_ms) {
  ordered_json json{{"ack", nullptr}, {"ok", !refusal}};
  if (command.seq) {
    json["ack"] = *command.seq;
  }
  if (refusal) {
    json["why"] = refusal->why;
    json["code"] = name_of(refusal->code);
  } else if (std::holds_alternative<AskClock>(command.request)) {
    json["clock"] = now_ms;
  }
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

CommandHandler::CommandHandler(std::optional<std::vector<std::string>> can,
                               std::function<double()> clock_ms)
    : can_(std::move(can)), clock_ms_(std::move(clock_ms)) {}

CommandHandler::Answer CommandHandler::answer(std::uint64_t client, std::string_view text) {
  const ClientCommand command = parse_command(text);
  const double now_ms = clock_ms_();
  const Taking taking = take(client, command, now_ms);
  Answer answer{answer_text(command, taking.refusal, now_ms), {}, taking.command};
  if (taking.refusal) {
    answer.refused = taking.refusal->code;
  }
  return answer;
}

std::optional<session::OperatorCommand> CommandHandler::close(std::uint64_t client) {
  names_.erase(client);
  if (!lock_.release(client, clock_ms_())) {
    return std::nullopt;
  }
  return session::StopRobot{session::StopRobot::Cause::kDriverGone};
}

std::optional<CommandHandler::Driver> CommandHandler::driver() const {
  const auto holder = lock_.holder(clock_ms_());
  if (!holder) {
    return std::nullopt;
  }
  const auto named = names_.find(*holder);
  return Driver{*holder, named == names_.end() ? std::string() : named->second};
}

CommandHandler::Taking CommandHandler::take(std::uint64_t client,
                                            const ClientCommand& command,
                                            double now_ms) {
  if (const auto* refusal = std::get_if<Refusal>(&command.request)) {
    return {*refusal, {}};
  }
  if (const auto* name = std::get_if<NameClient>(&command.request)) {
    names_[client] = name->name;
    return {};
  }
  if (std::holds_alternative<AskClock>(command.request)) {
    return {};
  }
  if (const auto refusal = refusal_of(command.name)) {
    return {refusal, {}};
  }
  if (const auto* drive = std::get_if<Drive>(&command.request)) {
    return take_drive(client, *drive, now_ms);
  }
  if (const auto* other = std::get_if<session::OperatorCommand>(&command.request)) {
    return take_other(client, *other, now_ms);
  }
  return take_release(client, now_ms);
}

CommandHandler::Taking CommandHandler::take_drive(std::uint64_t client,
                                                  const Drive& drive,
                                                  double now_ms) {
  if (drive.seen_ms < now_ms - kMaxSeenAgeMs || drive.seen_ms > now_ms + kClockRoundingMs) {
    return {Refusal{RefusalCode::kStale, "what was seen is not of now"}, {}};
  }
  const bool is_at_rest = drive.steer.forward == 0.0 && drive.steer.turn == 0.0;
  switch (lock_.steer(client, is_at_rest, now_ms)) {
    case DriverLock::Steering::kHeldByOther:
      return {not_driver(now_ms), {}};
    case DriverLock::Steering::kMustLetGo:
      return {Refusal{RefusalCode::kBusy, "the robot was stopped: let go of the stick first"}, {}};
    case DriverLock::Steering::kAllowed:
      break;
  }
  return {{}, drive.steer};
}

CommandHandler::Taking CommandHandler::take_other(std::uint64_t client,
                                                  const session::OperatorCommand& command,
                                                  double now_ms) {
  if (is_stop(command)) {
    lock_.stop();
    return {{}, command};
  }
  if (lock_.is_held_by_other(client, now_ms)) {
    return {not_driver(now_ms), {}};
  }
  if (drives_by_itself(command)) {
    lock_.release(client, now_ms);
  }
  return {{}, command};
}

CommandHandler::Taking CommandHandler::take_release(std::uint64_t client, double now_ms) {
  if (!lock_.release(client, now_ms)) {
    return {};
  }
  return {{}, session::StopRobot{session::StopRobot::Cause::kDriverGone}};
}

std::optional<Refusal> CommandHandler::refusal_of(const std::string& name) const {
  if (!can_) {
    return Refusal{RefusalCode::kNotPossible, "no run is live"};
  }
  const bool is_always_taken = name == "stop" || name == "release";
  if (is_always_taken || std::find(can_->begin(), can_->end(), name) != can_->end()) {
    return std::nullopt;
  }
  return Refusal{RefusalCode::kNotPossible, "this run does not take " + name};
}

Refusal CommandHandler::not_driver(double now_ms) const {
  const auto holder = lock_.holder(now_ms);
  if (!holder) {
    return {RefusalCode::kNotDriver, "somebody else drives"};
  }
  std::string who = "client " + std::to_string(*holder);
  const auto named = names_.find(*holder);
  if (named != names_.end() && !named->second.empty()) {
    who += " (" + named->second + ")";
  }
  return {RefusalCode::kNotDriver, who + " drives"};
}

}  // namespace echomap::live_page
