// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "tests/hil/robot_session.hpp"
#include "tests/hil/turning_wheel.hpp"

namespace echomap::tests {

/// What became of a robot that was driving when its program hung.
struct HangOutcome {
  double off_ms = 0.0;    ///< From the hang until both PWM outputs were off; infinite for never.
  double reset_ms = 0.0;  ///< Until the chip was reset.
  bool off_before_reset = false;
  bool stayed_off = false;       ///< From then on, through the reset and 50 ms behind it.
  std::uint8_t reset_cause = 0;  ///< As the robot tells it in its Hello; 0 where it tells nothing.
};

/// A robot whose motors turn its wheels: the release firmware and a host that drives it.
class RobotOnTheMove {
 public:
  static constexpr std::uint16_t kTimeToLiveMs = 200;
  static constexpr std::int16_t kTicksPerS = 1500;

  explicit RobotOnTheMove(const std::filesystem::path& elf,
                          world::MotorDriver driver = world::MotorDriver());

  /// How the robot's driver is wired, for its firmware.
  protocol::ConfigureWiring wiring() const;

  /// Throw std::runtime_error where the robot does not do it.
  void connect_and_arm();
  void drive();

  /// Whether its driver drives no motor.
  bool off();
  double now_ms() { return double(robot.board().now_ns()) * 1e-6; }
  /// Simulated milliseconds from now until both PWM outputs are off for good, which they
  /// must be within `watched_ms`, or infinity; a controller that brakes passes through 0 on its
  /// way.
  double ms_until_off(std::int64_t watched_ms);
  bool stays_off_for(std::int64_t ms);

  /// What the robot does now that its program hangs; the host falls silent.
  HangOutcome outcome_of_hang();

  RobotSession robot;
  const world::MotorDriver driver;
  DrivenWheel left{robot.board(), runner::Wheel::kLeft, driver};
  DrivenWheel right{robot.board(), runner::Wheel::kRight, driver};
  /// The host keeps motion alive.
  bool renewing = false;
};

/// From the last byte of the last KeepAlive to PWM off, of a robot at 1500 ticks/s that could do
/// 3000: time to live and half of the ramp. Milliseconds.
double measure_link_loss_ms(const std::filesystem::path& elf);
/// The longest from a bump to PWM off, over both sides and ten moments of the tick. Milliseconds.
double measure_bump_ms(const std::filesystem::path& elf);

}  // namespace echomap::tests
