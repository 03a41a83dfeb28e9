// SPDX-License-Identifier: MIT
#include "tests/hil/measure/robot_on_the_move.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace echomap::tests {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

void require(bool done, const char* what) {
  if (!done) {
    throw std::runtime_error(what);
  }
}

}  // namespace

RobotOnTheMove::RobotOnTheMove(const std::filesystem::path& elf, world::MotorDriver with_driver)
    : robot(elf), driver(with_driver) {
  robot.each_ms = [this] {
    left.step_ms();
    right.step_ms();
    if (renewing && robot.board().now_ns() / 1'000'000 % 50 == 0) {
      robot.send(protocol::KeepAlive{kTimeToLiveMs});
    }
  };
}

protocol::ConfigureWiring RobotOnTheMove::wiring() const {
  protocol::ConfigureWiring wiring{};
  wiring.bridge = static_cast<std::uint8_t>(driver.interface());
  const bool is_slow =
      driver.chip() == world::DriverChip::kL293d || driver.chip() == world::DriverChip::kMx1508;
  wiring.bridge_options = is_slow ? protocol::kSlowPwm : 0;
  return wiring;
}

void RobotOnTheMove::connect_and_arm() {
  require(robot.connect().has_value(), "the robot does not answer");
  if (driver.interface() != world::DriverInterface::kPhaseEnable) {
    require(robot.command(wiring()) == protocol::CommandStatus::kAccepted,
            "the robot does not take its driver");
  }
  require(robot.command(protocol::Arm{0, 1}) == protocol::CommandStatus::kAccepted,
          "the robot does not arm");
}

void RobotOnTheMove::drive() {
  connect_and_arm();
  robot.send(protocol::DriveSetpoint{kTicksPerS, kTicksPerS, kTimeToLiveMs});
  renewing = true;
  robot.run_ms(1000);
  const auto at_speed = [](const DrivenWheel& wheel) {
    return std::abs(wheel.ticks_per_s() - kTicksPerS) < 50.0;
  };
  require(at_speed(left) && at_speed(right), "the wheels do not get to their speed");
}

bool RobotOnTheMove::off() {
  const runner::MotorDuty duty = robot.board().motor_duty(driver);
  return duty.left == 0.0 && duty.right == 0.0;
}

double RobotOnTheMove::ms_until_off(std::int64_t watched_ms) {
  const double start_ms = now_ms();
  double last_on_ms = start_ms;
  robot.run_until(
      [&] {
        last_on_ms = off() ? last_on_ms : now_ms();
        return false;
      },
      watched_ms);
  return off() ? last_on_ms - start_ms : kNever;
}

bool RobotOnTheMove::stays_off_for(std::int64_t ms) {
  return !robot.run_until([this] { return !off(); }, ms);
}

HangOutcome RobotOnTheMove::outcome_of_hang() {
  renewing = false;
  robot.forget_heard();
  const double start_ms = now_ms();
  const auto ms_since_hang = [&] { return now_ms() - start_ms; };
  HangOutcome outcome;
  outcome.off_ms = robot.run_until([this] { return off(); }, 400) ? ms_since_hang() : kNever;
  outcome.off_before_reset = off() && robot.chip().resets() == 0;
  // The program starts again by a reset, or by itself.
  const auto on_or_reset = [this] {
    return !off() || robot.chip().resets() != 0 || robot.last<protocol::HelloReply>().has_value();
  };
  outcome.reset_ms = robot.run_until(on_or_reset, 400) ? ms_since_hang() : kNever;
  outcome.stayed_off = off() && stays_off_for(50);
  if (const auto hello = robot.last<protocol::HelloReply>()) {
    outcome.reset_cause = hello->reset_cause;
  }
  return outcome;
}

double measure_link_loss_ms(const std::filesystem::path& elf) {
  RobotOnTheMove moving(elf);
  moving.drive();
  moving.renewing = false;
  moving.robot.send(protocol::KeepAlive{RobotOnTheMove::kTimeToLiveMs});
  moving.robot.run_ms(1);  // the frame's eight bytes at 115200 baud and faster
  return moving.ms_until_off(1500);
}

double measure_bump_ms(const std::filesystem::path& elf) {
  double longest_ms = 0.0;
  for (const auto side : {runner::Wheel::kLeft, runner::Wheel::kRight}) {
    for (std::int64_t moment_us = 0; moment_us < 1000; moment_us += 100) {
      RobotOnTheMove moving(elf);
      moving.drive();
      moving.robot.board().run_until(moving.robot.board().now_ns() + moment_us * 1000);
      moving.robot.board().set_bump(side, true);
      longest_ms = std::max(longest_ms, moving.ms_until_off(150));
    }
  }
  return longest_ms;
}

}  // namespace echomap::tests
