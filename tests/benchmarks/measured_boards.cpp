// SPDX-License-Identifier: MIT
#include "tests/benchmarks/measured_boards.hpp"

#include <stdexcept>

#include "host/boards/boards.hpp"
#include "host/session/child_process.hpp"

namespace echomap::bench {

std::vector<MeasuredBoard> measured_boards() {
  std::vector<MeasuredBoard> measured;
  for (const boards::Board& board : boards::all_boards()) {
    if (!board.emulator.empty()) {
      const std::string name(board.name);
      const std::string emulator(board.emulator);
      measured.push_back({name,
                          std::string(board.robot),
                          "echomap-" + name,
                          "echomap-" + emulator,
                          "measure_on_" + emulator,
                          name != "ev3"});
    }
  }
  return measured;
}

MeasuredBoard measured_board(const std::string& name) {
  std::string names;
  for (const MeasuredBoard& board : measured_boards()) {
    if (board.name == name) {
      return board;
    }
    names += board.name + ", ";
  }
  throw std::invalid_argument("no emulated board '" + name + "'; there are " + names + "and all");
}

std::vector<MeasuredBoard> boards_named(const std::vector<std::string>& names) {
  if (names == std::vector<std::string>{"all"}) {
    return measured_boards();
  }
  std::vector<MeasuredBoard> boards;
  for (const std::string& name : names) {
    boards.push_back(measured_board(name));
  }
  return boards;
}

BuildFolders build_folders() {
  return {session::program_folder(), std::filesystem::path(ECHOMAP_BINARY_DIR) / "firmware"};
}

std::filesystem::path image_of(const MeasuredBoard& board, const BuildFolders& folders) {
  return folders.images / (board.image + ".elf");
}

std::string missing_of(const MeasuredBoard& board,
                       const std::string& program,
                       const BuildFolders& folders) {
  if (!std::filesystem::exists(image_of(board, folders))) {
    return image_of(board, folders).filename();
  }
  return std::filesystem::exists(folders.programs / program) ? "" : program;
}

}  // namespace echomap::bench
