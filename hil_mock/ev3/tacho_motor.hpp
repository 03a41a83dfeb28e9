// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "hil_mock/ev3/sysfs_file.hpp"

namespace echomap::ev3 {

/// What a motor is, as its folder tells it.
struct TachoMotorKind {
  std::string driver_name;
  long max_deg_per_s = 0;
};

/// LEGO 45502 and 45503; max_speed as in lego-linux-drivers, motors/tacho_motor_defs.c.
TachoMotorKind large_motor();
TachoMotorKind medium_motor();

/// A folder of /sys/class/tacho-motor and the rules of the kernel behind it, as lego-linux-drivers
/// has them. Plain files cannot refuse: what the kernel would answer with an error throws
/// std::runtime_error here.
class TachoMotor {
 public:
  /// `address` is that of the port: "ev3-ports:outA".
  TachoMotor(const std::filesystem::path& folder,
             const std::string& address,
             const TachoMotorKind& kind);

  /// Does what the program has written since the last call.
  void obey();
  /// Shows where the shaft is, in degrees since the start, as the kernel does 500 times a second.
  void show_position(std::int64_t shaft_deg);
  /// Turns for `dt_s` on its own, without anything to move: a motor that only carries a sensor.
  void turn_freely(double dt_s);

  /// What the motor gets, -1 .. 1, in the direction in which positions grow.
  double duty() const { return mode_ == Mode::kDirect ? duty_share_ : 0.0; }
  /// Whether it is short-circuited at no duty.
  bool brakes() const { return mode_ == Mode::kDirect || brakes_; }
  /// Where `turn_freely` has brought its shaft, in degrees since the start.
  double free_shaft_deg() const { return free_shaft_deg_; }
  /// Cuts its power, as the brick does that is switched off.
  void reset();

 private:
  enum class Mode : std::uint8_t { kStopped, kDirect, kToPosition };

  void obey(const std::string& command);
  void read_duty();
  void accept_position();
  [[noreturn]] void refuse(const std::string& why) const;

  std::string name_;
  TachoMotorKind kind_;
  SysfsFile command_;
  SysfsFile duty_cycle_sp_;
  SysfsFile stop_action_;
  SysfsFile polarity_;
  SysfsFile position_;
  SysfsFile position_sp_;
  SysfsFile speed_sp_;
  SysfsFile ramp_up_sp_;
  SysfsFile ramp_down_sp_;
  SysfsFile state_;
  Mode mode_ = Mode::kStopped;
  bool brakes_ = false;
  int sign_ = 1;
  double duty_share_ = 0.0;
  std::int64_t shaft_deg_ = 0;
  std::int64_t zero_deg_ = 0;
  double free_shaft_deg_ = 0.0;
  double goal_deg_ = 0.0;
  double goal_deg_per_s_ = 0.0;
};

}  // namespace echomap::ev3
