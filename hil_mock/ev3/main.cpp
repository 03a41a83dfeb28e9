// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <string>

#include "hil_mock/ev3/ev3_board.hpp"
#include "hil_mock/runner/device_main.hpp"

namespace {

echomap::ev3::RangeSensor range_sensor_of(const std::string& board) {
  using echomap::ev3::RangeSensor;
  if (board == "ev3-nxt") {
    return RangeSensor::kNxtSonar;
  }
  return board == "ev3-infrared" ? RangeSensor::kInfrared : RangeSensor::kUltrasonic;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace echomap;
  const auto make_board = [](const runner::BoardOptions& options) {
    const std::filesystem::path built = ECHOMAP_FIRMWARE_FOLDER "/echomap-ev3.elf";
    const std::filesystem::path& elf = options.firmware.empty() ? built : options.firmware;
    return std::make_unique<ev3::Ev3Board>(
        ev3::Ev3Options{ev3::under_qemu(elf), range_sensor_of(options.board)});
  };
  return runner::run_device(
      argc, argv, {"echomap-ev3", {"ev3", "ev3-nxt", "ev3-infrared"}, make_board, "ev3"});
}
