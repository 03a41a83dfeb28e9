// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "hil_mock/emulator/simavr_board.hpp"
#include "hil_mock/runner/device_main.hpp"

int main(int argc, char** argv) {
  using namespace echomap;
  const auto make_board = [](const runner::BoardOptions& options) {
    return std::make_unique<emulator::SimavrBoard>(options.firmware.empty() ? ECHOMAP_BUILT_UNO_ELF
                                                                            : options.firmware);
  };
  return runner::run_device(argc, argv, {"echomap-simavr", true, make_board});
}
