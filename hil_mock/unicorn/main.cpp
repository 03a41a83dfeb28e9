// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <memory>

#include "hil_mock/runner/device_main.hpp"
#include "hil_mock/unicorn/unicorn_board.hpp"

int main(int argc, char** argv) {
  using namespace echomap;
  const auto make_board = [](const runner::BoardOptions& options) {
    const std::filesystem::path built =
        ECHOMAP_FIRMWARE_FOLDER "/echomap-" + options.board + ".elf";
    return std::make_unique<unicorn::UnicornBoard>(options.firmware.empty() ? built
                                                                            : options.firmware);
  };
  return runner::run_device(argc, argv, {"echomap-unicorn", {"stm32f103"}, make_board});
}
