// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

#include "hil_mock/runner/descriptor.hpp"

namespace echomap::ev3 {

/// A program and what it starts, in a group of processes of its own, with pipes at its standard
/// input and output. All of them are killed with their owner, and where that is killed, with the
/// thread that has made it.
class FirmwareProcess {
 public:
  /// Runs `command`, which is looked for in PATH. Throws std::system_error where it cannot.
  explicit FirmwareProcess(const std::vector<std::string>& command);
  ~FirmwareProcess();
  FirmwareProcess(const FirmwareProcess&) = delete;
  FirmwareProcess& operator=(const FirmwareProcess&) = delete;

  /// Puts bytes into its standard input; those that do not fit are lost, as are all once it reads
  /// no more.
  void write(std::span<const std::uint8_t> bytes);
  /// Appends what it has written to its standard output.
  void read(std::vector<std::uint8_t>& into);
  /// How it has ended, as a shell tells it; empty while it runs.
  std::optional<int> exit_status();
  /// Of the program that was started.
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = -1;
  std::optional<int> status_;
  runner::Descriptor input_;
  runner::Descriptor output_;
};

}  // namespace echomap::ev3
