// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/live_page/client_command.hpp"
#include "host/live_page/driver_lock.hpp"

namespace echomap::live_page {

/// What the clients of one live run are allowed to do with it, and when.
class CommandHandler {
 public:
  /// Of what a driver has seen; older than that it cannot know what it does.
  static constexpr double kMaxSeenAgeMs = 400.0;
  /// Of those that post their commands; all of them together are one client.
  static constexpr std::uint64_t kPostingClient = 0;

  /// Of the client that holds the driver lock.
  struct Driver {
    std::uint64_t client = 0;
    std::string name;
  };
  /// What is said to the client, and what the robot has to do.
  struct Answer {
    std::string text;
    std::optional<RefusalCode> refused;
    std::optional<session::OperatorCommand> command;
  };

  /// `can` names the commands that the run takes; nothing: there is no live run.
  CommandHandler(std::optional<std::vector<std::string>> can, std::function<double()> clock_ms);

  /// From now on the run takes these.
  void set_can(std::vector<std::string> can) { can_ = std::move(can); }
  Answer answer(std::uint64_t client, std::string_view text);
  /// The client is gone: a robot that it drove has to stop.
  std::optional<session::OperatorCommand> close(std::uint64_t client);
  std::optional<Driver> driver() const;

 private:
  struct Taking;

  Taking take(std::uint64_t client, const ClientCommand& command, double now_ms);
  Taking take_drive(std::uint64_t client, const Drive& drive, double now_ms);
  Taking take_other(std::uint64_t client, const session::OperatorCommand& command, double now_ms);
  Taking take_release(std::uint64_t client, double now_ms);
  std::optional<Refusal> refusal_of(const std::string& name) const;
  Refusal not_driver(double now_ms) const;

  std::optional<std::vector<std::string>> can_;
  std::function<double()> clock_ms_;
  DriverLock lock_;
  std::map<std::uint64_t, std::string> names_;
};

}  // namespace echomap::live_page
