// SPDX-License-Identifier: MIT
#include "tests/benchmarks/measured_boards.hpp"

#include <algorithm>
#include <stdexcept>

#include "host/session/child_process.hpp"

namespace echomap::bench {

const std::vector<MeasuredBoard>& measured_boards() {
  static const std::vector<MeasuredBoard> boards{
      {"uno", "uno_2wd", "echomap-uno", "echomap-simavr", "measure_on_simavr"},
      {"mega", "uno_2wd", "echomap-mega", "echomap-simavr", "measure_on_simavr"},
      {"stm32f103", "uno_2wd", "echomap-stm32f103", "echomap-unicorn", "measure_on_unicorn"},
      {"pico", "pico_2wd", "echomap-pico", "echomap-rp2040", "measure_on_rp2040"},
      {"ev3", "ev3", "echomap-ev3", "echomap-ev3", "measure_on_ev3", false}};
  return boards;
}

const MeasuredBoard& measured_board(const std::string& name) {
  const auto& boards = measured_boards();
  const auto found = std::find_if(
      boards.begin(), boards.end(), [&](const auto& board) { return board.name == name; });
  if (found == boards.end()) {
    throw std::invalid_argument("no board '" + name +
                                "'; there are uno, mega, stm32f103, pico, ev3 and all");
  }
  return *found;
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
