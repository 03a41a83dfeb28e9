// SPDX-License-Identifier: MIT
#include "host/apps/member_processes.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <thread>

#include <fmt/format.h>

#include "host/console/exit_code.hpp"

namespace echomap::apps {
namespace {

using console::ExitCode;

constexpr std::chrono::seconds kEndPatience{30};

}  // namespace

void MemberProcesses::start(const std::string& name,
                            const std::vector<std::string>& command,
                            const std::filesystem::path& log) {
  names_.push_back(name);
  processes_.push_back(std::make_unique<session::ChildProcess>(command, log));
  statuses_.emplace_back();
}

bool MemberProcesses::go_on() {
  bool any = false;
  for (std::size_t i = 0; i < processes_.size(); ++i) {
    statuses_[i] = processes_[i]->exit_status();
    any = any || !statuses_[i];
  }
  return any;
}

void MemberProcesses::interrupt() {
  for (const auto& process : processes_) {
    process->send(SIGTERM);
  }
}

void MemberProcesses::wait_for_all() {
  const auto end = std::chrono::steady_clock::now() + kEndPatience;
  while (go_on() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

nlohmann::ordered_json MemberProcesses::exits() const {
  auto exits = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const std::optional<int>& status = statuses_[i];
    exits[names_[i]] = status ? nlohmann::ordered_json(*status) : nullptr;
  }
  return exits;
}

bool MemberProcesses::has_lost_one() const {
  return std::ranges::any_of(statuses_, [](const std::optional<int>& status) {
    return status != static_cast<int>(ExitCode::kOk) &&
           status != static_cast<int>(ExitCode::kUnfinished);
  });
}

bool MemberProcesses::has_lost_one_unheard(const fleet::FleetState& state) const {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const bool has_reported = std::ranges::any_of(state.robots, [&](const auto& robot) {
      return robot.name == names_[i] && robot.has_reported;
    });
    if (statuses_[i] && !has_reported) {
      return true;
    }
  }
  return false;
}

std::vector<std::string> MemberProcesses::unfinished() const {
  constexpr int kToldToEnd = 128 + SIGTERM;
  std::vector<std::string> unfinished;
  std::vector<std::string> told_to_end;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (const int status = statuses_[i].value_or(1); status != 0) {
      auto& group = status == kToldToEnd ? told_to_end : unfinished;
      group.push_back(fmt::format("{} (exit {})", names_[i], status));
    }
  }
  unfinished.insert(unfinished.end(), told_to_end.begin(), told_to_end.end());
  return unfinished;
}

}  // namespace echomap::apps
