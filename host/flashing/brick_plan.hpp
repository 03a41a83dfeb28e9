// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/console/shell_line.hpp"

namespace echomap::flashing {

/// One of the commands that have to succeed one after the other.
struct FlashStep {
  console::CommandWords command;
  std::string what;       ///< What it does, in words: "copy the program to the brick".
  std::string advice;     ///< What to look at where it fails.
  int refusal = -1;       ///< The exit code by which it says that `refused` is so; -1: none.
  std::string refused{};  ///< What is wrong then, with the next step.
};

/// How a program gets onto a brick, and how it is reached from then on.
struct BrickPlan {
  std::string host;  ///< USER@NAME.
  std::vector<FlashStep> steps;
  std::string address;  ///< The `--port` of the robot.
};

/// Where the firmware of a brick listens, unless told otherwise.
constexpr int kBrickTcpPort = 8375;

/// A host as ssh takes it, USER@NAME or NAME, for `--host`; what is wrong with it, or empty. A name
/// that begins with a dash would be an option of ssh.
std::string fault_of_host(const std::string& host);

/// What is wrong with a program for the EV3: it has to be an ELF for Linux on a 32-bit ARM, without
/// shared libraries and without instructions of a floating-point unit, which the brick lacks. Empty
/// where nothing is.
std::string fault_of_brick_program(const std::filesystem::path& program);

/// The commands that copy `program` to the brick with scp and have systemd start it by ssh, now and
/// whenever its user logs in. It listens on `kBrickTcpPort`.
BrickPlan brick_plan(const std::string& host, const std::string& program);

}  // namespace echomap::flashing
