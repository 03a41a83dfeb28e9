// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace echomap::bench {

/// A board that figures are measured on, and what its emulator is.
struct MeasuredBoard {
  std::string name;      ///< As `echomap demo --board` takes it.
  std::string robot;     ///< Profile of the robot that has it.
  std::string image;     ///< "echomap-uno": the name of its ELF file.
  std::string program;   ///< The device program that emulates it: "echomap-simavr".
  std::string measures;  ///< The program that measures over the same emulator.
  /// The firmware sees the edges of encoders and echoes; else motors and sonar measure for
  /// themselves.
  bool counts_edges = true;
};

/// All boards that have an emulator, in the order of the host's table.
std::vector<MeasuredBoard> measured_boards();

/// The board of that name. Throws std::invalid_argument, naming those there are.
MeasuredBoard measured_board(const std::string& name);

/// These boards, or all for {"all"}. Throws as measured_board.
std::vector<MeasuredBoard> boards_named(const std::vector<std::string>& names);

/// Where a build has its programs and its images.
struct BuildFolders {
  std::filesystem::path programs;
  std::filesystem::path images;
};
/// Those of the build that this program is of.
BuildFolders build_folders();

/// The file of `board`'s image.
std::filesystem::path image_of(const MeasuredBoard& board, const BuildFolders& folders);

/// What `board` needs and the build lacks: its image or `program`; empty where it has both.
std::string missing_of(const MeasuredBoard& board,
                       const std::string& program,
                       const BuildFolders& folders);

}  // namespace echomap::bench
