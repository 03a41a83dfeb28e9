// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace echomap::session {

/// A program started by this one. Its output goes to a log file; it is ended with its owner, and
/// where that is killed, with the thread that has made it.
class ChildProcess {
 public:
  /// `command[0]` is the program's path. Throws std::runtime_error where it cannot be started.
  ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& log);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Its number, which another process may have once it has ended.
  pid_t pid() const { return pid_; }
  /// The exit status once it has ended (128 + signal where a signal ended it), without waiting.
  std::optional<int> exit_status();
  /// Processor seconds of it and of those that it has started and seen end; 0 while it runs.
  double cpu_s() const { return cpu_s_; }
  /// Sends a signal, unless it has ended.
  void send(int signal);
  /// Waits for the end; empty where it still runs after `limit`.
  std::optional<int> wait_for(std::chrono::milliseconds limit);

 private:
  pid_t pid_ = -1;
  std::optional<int> status_;
  double cpu_s_ = 0.0;
};

/// The folder of the running program.
std::filesystem::path program_folder();

}  // namespace echomap::session
