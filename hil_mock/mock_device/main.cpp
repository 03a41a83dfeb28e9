// SPDX-License-Identifier: MIT
#include "hil_mock/mock_device/mock_board.hpp"
#include "hil_mock/runner/device_main.hpp"

int main(int argc, char** argv) {
  using namespace echomap;
  return runner::run_device(argc, argv, {"echomap-mock", {}, [](const runner::BoardOptions&) {
                                           return std::make_unique<mock_device::MockBoard>();
                                         }});
}
