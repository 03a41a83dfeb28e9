// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/control/distance_ramp.hpp"
#include "firmware/control/driven_wheel.hpp"
#include "firmware/control/motion_report.hpp"
#include "firmware/control/proportion.hpp"
#include "firmware/control/speed_ramp.hpp"
#include "firmware/drivers/wheel_encoders.hpp"
#include "protocol/command_messages.hpp"

namespace echomap {
namespace control {

/// Both wheels: moves by counts, and speeds. Where a motion ends as told the motors are left at
/// duty 0, which may brake; where it is cut short, and when the time to live is over, they are
/// released.
class WheelMotion {
 public:
  /// `settings` and `limits` are where the active ones stand.
  constexpr WheelMotion(drivers::WheelEncoders& encoders,
                        protocol::ConfigureDrive& settings,
                        const protocol::ConfigureSafety& limits)
      : encoders_(encoders), settings_(settings), limits_(limits) {}

  /// True when every field is in range.
  static bool accepts(const protocol::ConfigureDrive& settings);
  /// Takes settings that `accepts` has granted; only while not moving.
  void configure(const protocol::ConfigureDrive& settings);
  /// The same for what the motors are connected to; both are released.
  static bool accepts(const protocol::ConfigureWiring& wiring);
  void configure(const protocol::ConfigureWiring& wiring);

  /// True when the settings allow the way and the speed of `move`.
  bool accepts(const protocol::MoveTicks& move) const;
  /// Starts a move that `accepts` has granted; only while not moving.
  void start_move(const protocol::MoveTicks& move);
  /// Takes over with wheel speeds in ticks/s, each clipped to the settings' limit. After a stall of
  /// set-points none does anything before one of zero speed, or `stop`: a host that goes on sending
  /// must not heat a blocked motor.
  void drive(int16_t left_ticks_per_s, int16_t right_ticks_per_s);

  /// Motors off at once, for this reason. That of a motion which is over is not told any more, but
  /// kLifted is, of a standing robot too.
  void stop(protocol::MotionOutcome reason);
  /// The time to live is over: brakes hard and lets go there, arrived or not; a robot that rests
  /// lets go at once.
  void expire();
  /// One control period. False when a wheel is out of control, kRunaway or kOverSpeed: both were
  /// stopped, and had better not start again before somebody has looked.
  bool step();

  bool moving() const { return mode_ != Mode::kIdle; }
  /// True while the robot as a whole goes forward or is about to; false for a turn on the spot.
  bool goes_forward() const;
  /// True while both wheels go backwards or nowhere, and will.
  bool only_backs_off() const;
  MotionReport report() const { return report_; }

 private:
  enum class Mode : uint8_t { kIdle, kMove, kDrive };
  /// What both references do in a period, or in the whole of a move.
  struct Steps {
    int32_t left;
    int32_t right;
  };

  void set_course(int32_t left, int32_t right);
  void begin(Mode mode);
  void take_over();
  bool setpoint_stalled() const;
  void release();
  void end(protocol::MotionOutcome outcome);
  Steps next_steps();
  int32_t clipped_target(int16_t ticks_per_s) const;
  bool reference_stands() const;

  drivers::WheelEncoders& encoders_;
  protocol::ConfigureDrive& settings_;
  const protocol::ConfigureSafety& limits_;
  DistanceRamp way_;
  Proportion shorter_;
  SpeedRamp left_ramp_;
  SpeedRamp right_ramp_;
  Steps last_steps_ = {0, 0};
  Steps move_ticks_ = {0, 0};
  Mode mode_ = Mode::kIdle;
  bool expired_ = false;
  bool told_forward_ = false;
  bool told_to_back_off_ = false;
  MotionReport report_ = {0, protocol::MotionOutcome::kNone};
  DrivenWheel left_{hal::Motor::kLeft};
  DrivenWheel right_{hal::Motor::kRight};
};

}  // namespace control
}  // namespace echomap
