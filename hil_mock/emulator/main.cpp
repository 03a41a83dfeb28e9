// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>

#include "hil_mock/emulator/simavr_board.hpp"
#include "hil_mock/runner/device_main.hpp"

int main(int argc, char** argv) {
  using namespace echomap;
  const auto make_board = [](const runner::BoardOptions& options) {
    const std::filesystem::path built =
        ECHOMAP_FIRMWARE_FOLDER "/echomap-" + options.board + ".elf";
    return std::make_unique<emulator::SimavrBoard>(options.firmware.empty() ? built
                                                                            : options.firmware);
  };
  return runner::run_device(argc, argv, {"echomap-simavr", {"uno", "mega"}, make_board});
}
