// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>

#include "hil_mock/ev3/ev3_board.hpp"
#include "hil_mock/runner/device_main.hpp"

int main(int argc, char** argv) {
  using namespace echomap;
  const auto make_board = [](const runner::BoardOptions& options) {
    const std::filesystem::path built = ECHOMAP_FIRMWARE_FOLDER "/echomap-ev3.elf";
    const std::filesystem::path& elf = options.firmware.empty() ? built : options.firmware;
    return std::make_unique<ev3::Ev3Board>(ev3::Ev3Options{ev3::under_qemu(elf)});
  };
  return runner::run_device(argc, argv, {"echomap-ev3", {"ev3"}, make_board});
}
