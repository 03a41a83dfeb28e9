// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::runner {

/// What a program's board is made from.
struct BoardOptions {
  /// The ELF of `--firmware`; empty where the option was not given.
  std::filesystem::path firmware;
  /// That of `--board`: one of DeviceProgram::boards.
  std::string board;
};

/// A program that runs one simulated board: its name and how it makes the board.
struct DeviceProgram {
  /// As in `--version` and messages: "echomap-mock".
  std::string name;
  /// Boards whose firmware this program runs, the usual one first: `--board` chooses the one built
  /// here, `--firmware` any other ELF. Empty: neither is an option.
  std::vector<std::string> boards;
  /// Makes a board that is switched on at its time 0; may throw std::exception (exit code 1).
  std::function<std::unique_ptr<SimulatedBoard>(const BoardOptions&)> make_board;
  /// What `--robot` is by default: the robot of the usual board.
  std::string robot = "uno_2wd";
};

/// The whole program: reads the command line, couples board and world, serves the byte stream and
/// the lockstep channel, writes the truth. Returns the exit code: 0 ok, 1 runtime error, 2 usage,
/// 6 world or robot file invalid.
int run_device(int argc, char** argv, const DeviceProgram& program);

}  // namespace echomap::runner
