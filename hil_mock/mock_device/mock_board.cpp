// SPDX-License-Identifier: MIT
#include "hil_mock/mock_device/mock_board.hpp"

#include "protocol/version.hpp"

namespace echomap::mock_device {
namespace {

constexpr double kFullDuty = 255.0;

}  // namespace

MockBoard::MockBoard() : board_(native::NativeBoard::instance()) {
  board_.on_sent = [this](std::uint8_t byte) {
    if (on_sent) {
      on_sent(byte);
    }
  };
  board_.on_trigger = [this](std::int64_t at_ns) {
    if (on_trigger) {
      on_trigger(at_ns);
    }
  };
  board_.set_bump(false, false);
  board_.set_bump(true, false);
  board_.power_on();
}

MockBoard::~MockBoard() {
  board_.on_sent = nullptr;
  board_.on_trigger = nullptr;
}

void MockBoard::receive(std::span<const std::uint8_t> bytes) {
  board_.receive(bytes.data(), bytes.size());
}

runner::MotorDuty MockBoard::motor_duty() const {
  return {board_.left_duty() / kFullDuty, board_.right_duty() / kFullDuty};
}

void MockBoard::schedule_encoder_edge(runner::Wheel wheel, std::int64_t at_ns, bool a, bool b) {
  board_.schedule_encoder_edge(wheel == runner::Wheel::kRight, at_ns, a, b);
}

void MockBoard::schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) {
  board_.schedule_echo(rise_ns, fall_ns);
}

void MockBoard::set_bump(runner::Wheel side, bool pressed) {
  board_.set_bump(side == runner::Wheel::kRight, pressed);
}

std::string MockBoard::firmware_name() const {
  constexpr unsigned kVersion = protocol::kFirmwareVersion;
  return "echomap-native " + std::to_string(kVersion / 100) + "." +
         std::to_string(kVersion / 10 % 10) + "." + std::to_string(kVersion % 10);
}

std::string MockBoard::emulator_name() const { return "mock"; }

}  // namespace echomap::mock_device
