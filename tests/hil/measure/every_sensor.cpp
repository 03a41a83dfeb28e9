// SPDX-License-Identifier: MIT
#include "tests/hil/measure/every_sensor.hpp"

#include <cstddef>
#include <map>
#include <string>

namespace echomap::tests {
namespace {

using protocol::CommandStatus;

constexpr std::uint8_t kGyroPeriodMs = 10;
constexpr std::uint8_t kRangesPeriodMs = 50;

/// Functions of the spare pins, in their order. The inputs' pull-ups say that all is well.
const std::map<std::string, std::vector<std::uint8_t>>& functions_by_board() {
  using namespace protocol;
  static const std::map<std::string, std::vector<std::uint8_t>> by_board{
      // 3 and 4 are the bus of the gyro.
      {"uno",
       {kPinCliffLeft,
        kPinCliffRight,
        kPinWheelDrop,
        kPinUnused,
        kPinUnused,
        kPinRange0,
        kPinBattery}},
      {"mega",
       {kPinCliffLeft,
        kPinCliffFrontLeft,
        kPinCliffFrontRight,
        kPinCliffRight,
        kPinWheelDrop,
        kPinVirtualWall,
        kPinWall,
        kPinUnused,
        kPinRange0,
        kPinRange0 + 1,
        kPinRange0 + 2,
        kPinRange0 + 3,
        kPinRange0 + 4,
        kPinRange0 + 5,
        kPinRange0 + 6,
        kPinBattery}}};
  return by_board;
}

/// Fills the fields pin_0 .. pin_15 from a list.
struct PinWriter {
  const std::vector<std::uint8_t>& functions;
  std::size_t pin = 0;

  void operator()(const char* name, std::uint8_t& field) {
    if (std::string(name) != "command_id" && pin < functions.size()) {
      field = functions[pin++];
    }
  }
};

}  // namespace

bool EverySensor::knows(const std::string& board) { return functions_by_board().contains(board); }

EverySensor::EverySensor(runner::SimulatedBoard& board)
    : gyro_(world::RateGyro({0.0, 0.0, 0.0, 0.0},
                            world::NoiseStream(1, world::NoisePurpose::kGyro))) {
  board.connect(gyro_);
}

bool EverySensor::switch_on(RobotSession& robot) {
  const std::vector<std::uint8_t>& functions = functions_by_board().at(robot.board().board_name());
  protocol::ConfigurePins pins{};
  PinWriter writer{functions};
  protocol::ConfigurePins::each(pins, writer);
  const protocol::ConfigureSensors rates{0, kRangesPeriodMs, kGyroPeriodMs, 1};
  return robot.command(pins) == CommandStatus::kAccepted &&
         robot.command(rates) == CommandStatus::kAccepted;
}

}  // namespace echomap::tests
