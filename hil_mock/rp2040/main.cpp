// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>

#include "hil_mock/rp2040/rp2040_board.hpp"
#include "hil_mock/runner/device_main.hpp"

int main(int argc, char** argv) {
  using namespace echomap;
  const auto make_board = [](const runner::BoardOptions& options) {
    const std::filesystem::path built = ECHOMAP_FIRMWARE_FOLDER "/echomap-pico.elf";
    return std::make_unique<rp2040::Rp2040Board>(
        options.firmware.empty() ? built : options.firmware,
        options.board == "pico-uart" ? rp2040::PicoLine::kUart : rp2040::PicoLine::kUsb);
  };
  return runner::run_device(
      argc, argv, {"echomap-rp2040", {"pico", "pico-uart"}, make_board, "pico_2wd"});
}
