// SPDX-License-Identifier: MIT
#include "hil_mock/runner/aux_wiring.hpp"

#include <cmath>
#include <string>

#include "host/files/toml_reader.hpp"

namespace echomap::runner {
namespace {

using world::PinPart;

world::PinWires wires_for(const std::string& board, const world::RobotParams& robot) {
  const auto found = robot.wiring.find(board);
  if (found != robot.wiring.end()) {
    return found->second;
  }
  if (robot.wiring.empty()) {
    return {};
  }
  std::string others;
  for (const auto& [name, wires] : robot.wiring) {
    others += (others.empty() ? "" : ", ") + name;
  }
  throw files::ConfigError("the robot " + robot.name + " is not wired for the board " + board +
                           "; its file has [wiring] for: " + others +
                           "\n  next: run it on one of these, or add [wiring." + board +
                           "] to its file");
}

bool is_voltage(PinPart part) { return part >= PinPart::kBattery && part <= PinPart::kRange7; }

}  // namespace

AuxWiring::AuxWiring(SimulatedBoard& board, world::RobotWorld& world)
    : board_(board), world_(world), wires_(wires_for(board.board_name(), world.robot())) {
  if (world::Mpu6050* const gyro = world.parts().gyro()) {
    board_.connect(*gyro);
  }
  drive_inputs();
}

void AuxWiring::drive_inputs() {
  for (unsigned pin = 0; pin < wires_.size(); ++pin) {
    const auto& wire = wires_.at(pin);
    if (!wire) {
      continue;
    }
    if (wire->part == PinPart::kScalarPulses) {
      send_pulses(pin);
    } else if (is_voltage(wire->part)) {
      board_.set_aux_millivolts(pin, world_.parts().millivolts(wire->part));
    } else if (wire->part < PinPart::kStepperA) {
      drive_level(pin, *wire);
    }
  }
}

world::Coils AuxWiring::coils() const {
  world::Coils coils{};
  for (unsigned pin = 0; pin < wires_.size(); ++pin) {
    const auto& wire = wires_.at(pin);
    if (wire && wire->part >= PinPart::kStepperA) {
      const auto coil =
          static_cast<std::size_t>(wire->part) - static_cast<std::size_t>(PinPart::kStepperA);
      coils.at(coil) = board_.aux_output(pin);
    }
  }
  return coils;
}

void AuxWiring::send_pulses(unsigned pin) {
  if (!levels_.at(pin)) {
    levels_.at(pin) = true;
    board_.set_aux_level(pin, true);
  }
  const std::int64_t now_ns = board_.now_ns();
  for (const world::LowPulse& pulse : world_.parts().pulses()) {
    board_.schedule_aux_pulse(
        pin, now_ns + std::llround(pulse.fall_s * 1e9), now_ns + std::llround(pulse.rise_s * 1e9));
  }
}

void AuxWiring::drive_level(unsigned pin, const world::PinWire& wire) {
  const bool level = world_.parts().is_active(wire.part) == wire.active_high;
  if (levels_.at(pin) != level) {
    levels_.at(pin) = level;
    board_.set_aux_level(pin, level);
  }
}

}  // namespace echomap::runner
