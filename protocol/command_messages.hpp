// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/message_schema.hpp"

namespace echomap {
namespace protocol {

/// Bits of `ConfigureDrive::inversions`.
enum DriveInversions : uint8_t {
  kInvertLeftMotor = 1U << 0,
  kInvertRightMotor = 1U << 1,
  kInvertLeftEncoder = 1U << 2,
  kInvertRightEncoder = 1U << 3,
};

/// Allows (1) or forbids (0) the wheels to turn; forbidding stops them and a sweep at once. A sweep
/// needs no arming: a robot may look around before it drives.
struct Arm {
  enum : uint8_t { kId = 0x10 };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "Arm"; }
  uint8_t command_id;
  uint8_t armed;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("armed", m.armed);
  }
};

/// Stops wheels and sweep at once; the robot stays armed.
struct Stop {
  enum : uint8_t { kId = 0x11 };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "Stop"; }
  uint8_t command_id;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
  }
};

/// Drive of the robot's profile. Duty is +-255; gains are duty per 256 units of error.
struct ConfigureDrive {
  enum : uint8_t { kId = 0x12 };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "ConfigureDrive"; }
  uint8_t command_id;
  uint8_t inversions;
  uint16_t max_ticks_per_s;
  uint16_t max_ticks_per_s2;
  uint16_t feed_forward;  ///< Duty x 256 per tick/s of reference speed.
  uint16_t proportional;  ///< Duty x 256 per tick/s of speed error.
  uint16_t integral;      ///< Duty x 256 per tick of lag (the integral of speed error).
  uint8_t odometry_period_ms;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("inversions", m.inversions);
    v("max_ticks_per_s", m.max_ticks_per_s);
    v("max_ticks_per_s2", m.max_ticks_per_s2);
    v("feed_forward", m.feed_forward);
    v("proportional", m.proportional);
    v("integral", m.integral);
    v("odometry_period_ms", m.odometry_period_ms);
  }
};

/// Sonar of the robot's profile.
struct ConfigureSonar {
  enum : uint8_t { kId = 0x13 };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "ConfigureSonar"; }
  uint8_t command_id;
  uint16_t max_echo_us;  ///< A later echo counts as none.
  uint8_t ping_gap_ms;   ///< Least time from one ping to the next.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("max_echo_us", m.max_echo_us);
    v("ping_gap_ms", m.ping_gap_ms);
  }
};

/// Moves both wheels by counts, together and with ramps (the tacho limit of Singh and Bedi 2013,
/// section 2.4); `ticks_per_s` is the speed of the wheel that goes farther.
struct MoveTicks {
  enum : uint8_t { kId = 0x14 };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "MoveTicks"; }
  uint8_t command_id;
  int32_t left_ticks;
  int32_t right_ticks;
  uint16_t ticks_per_s;
  uint16_t time_to_live_ms;  ///< Renewed by every KeepAlive.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("left_ticks", m.left_ticks);
    v("right_ticks", m.right_ticks);
    v("ticks_per_s", m.ticks_per_s);
    v("time_to_live_ms", m.time_to_live_ms);
  }
};

/// Reads the sonar at from, from + step, .. up to and including `to`, after `settle_ms` at each; a
/// pan that turns more than once takes angles beyond a half turn.
struct StartSweep {
  enum : uint8_t { kId = 0x15 };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "StartSweep"; }
  uint8_t command_id;
  int32_t from_cdeg;
  int32_t to_cdeg;
  int32_t step_cdeg;
  uint16_t settle_ms;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("from_cdeg", m.from_cdeg);
    v("to_cdeg", m.to_cdeg);
    v("step_cdeg", m.step_cdeg);
    v("settle_ms", m.settle_ms);
  }
};

/// What turns the sonar, in ConfigurePan::kind.
enum class PanKind : uint8_t {
  kServo = 0,
  kStepper = 1,  ///< Its pins are the stepper phases of ConfigurePins; straight ahead at the start.
};

/// Pan drive of the robot's profile.
struct ConfigurePan {
  enum : uint8_t { kId = 0x16 };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "ConfigurePan"; }
  uint8_t command_id;
  uint8_t kind;            ///< A PanKind.
  uint16_t centre_us;      ///< Servo pulse that looks straight ahead.
  int16_t us_per_90deg;    ///< Servo: change of the pulse for 90 degrees to the left.
  int16_t steps_per_turn;  ///< Stepper: half steps; negative where they turn it right.
  int32_t min_cdeg;
  int32_t max_cdeg;
  uint16_t deg_per_s;  ///< Speed: of the servo, for the wait before a reading; of the stepper.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("kind", m.kind);
    v("centre_us", m.centre_us);
    v("us_per_90deg", m.us_per_90deg);
    v("steps_per_turn", m.steps_per_turn);
    v("min_cdeg", m.min_cdeg);
    v("max_cdeg", m.max_cdeg);
    v("deg_per_s", m.deg_per_s);
  }
};

/// What a spare pin does, in bits 0 .. 6 of ConfigurePins::pin_N; kPinActiveHigh may be added to
/// those that are read as digital levels.
enum PinFunction : uint8_t {
  kPinUnused = 0,
  kPinCliffLeft = 1,  ///< .. kPinWall in the order of the bits of Hazard.
  kPinCliffFrontLeft = 2,
  kPinCliffFrontRight = 3,
  kPinCliffRight = 4,
  kPinWheelDrop = 5,
  kPinVirtualWall = 6,
  kPinWall = 7,
  kPinBattery = 8,
  kPinScalarLevel = 9,     ///< Scalar: a voltage, of which the robot sums up conversions.
  kPinScalarPulses = 10,   ///< Scalar: pulses of 50 us or more, counted at their falling edges.
  kPinRange0 = 16,         ///< .. 23: Ranges::channel_0 .. channel_7.
  kPinStepperPhaseA = 32,  ///< .. 35: A, B, C, D.
  kPinActiveHigh = 0x80,
};

/// What the board's spare pins do; a PinFunction each, in the order of the board's page in
/// docs/hardware.
struct ConfigurePins {
  enum : uint8_t { kId = 0x17 };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "ConfigurePins"; }
  uint8_t command_id;
  uint8_t pin_0;
  uint8_t pin_1;
  uint8_t pin_2;
  uint8_t pin_3;
  uint8_t pin_4;
  uint8_t pin_5;
  uint8_t pin_6;
  uint8_t pin_7;
  uint8_t pin_8;
  uint8_t pin_9;
  uint8_t pin_10;
  uint8_t pin_11;
  uint8_t pin_12;
  uint8_t pin_13;
  uint8_t pin_14;
  uint8_t pin_15;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("pin_0", m.pin_0);
    v("pin_1", m.pin_1);
    v("pin_2", m.pin_2);
    v("pin_3", m.pin_3);
    v("pin_4", m.pin_4);
    v("pin_5", m.pin_5);
    v("pin_6", m.pin_6);
    v("pin_7", m.pin_7);
    v("pin_8", m.pin_8);
    v("pin_9", m.pin_9);
    v("pin_10", m.pin_10);
    v("pin_11", m.pin_11);
    v("pin_12", m.pin_12);
    v("pin_13", m.pin_13);
    v("pin_14", m.pin_14);
    v("pin_15", m.pin_15);
  }
};

/// Rates of the sensors beside wheels and sonar; 0 switches one off.
struct ConfigureSensors {
  enum : uint8_t { kId = 0x18 };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "ConfigureSensors"; }
  uint8_t command_id;
  uint8_t ranges_period_ms;
  uint8_t gyro_period_ms;
  uint8_t gyro_range;  ///< MPU-6050 FS_SEL, 0 .. 3: 250 .. 2000 degrees a second.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("ranges_period_ms", m.ranges_period_ms);
    v("gyro_period_ms", m.gyro_period_ms);
    v("gyro_range", m.gyro_range);
  }
};

/// When the board stops by itself.
struct ConfigureSafety {
  enum : uint8_t { kId = 0x19 };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "ConfigureSafety"; }
  uint8_t command_id;
  uint8_t hazard_stops;  ///< Bits of Hazard that stop the wheels; a wheel-drop does always.
  uint16_t stall_ms;  ///< A driven wheel without an edge for this long has stalled; 0: not watched.
  uint16_t runaway_ticks;  ///< Counts against the command that are too many; 0: not watched.
  uint16_t over_speed_ticks_per_s;  ///< 0: not watched.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("hazard_stops", m.hazard_stops);
    v("stall_ms", m.stall_ms);
    v("runaway_ticks", m.runaway_ticks);
    v("over_speed_ticks_per_s", m.over_speed_ticks_per_s);
  }
};

/// What stands between the board and the motors, in ConfigureWiring::bridge: what its inputs mean.
enum class MotorBridgeKind : uint8_t {
  kPhaseEnable = 0,  ///< A direction and a PWM: DRV8835 in its mode PHASE/ENABLE.
  kIn1In2Pwm = 1,    ///< Two directions and a PWM: TB6612FNG, L298N, L293D.
  kTwoPwm = 2,       ///< Two inputs, one of which gets the PWM: DRV8833, MX1508.
  kServo = 3,        ///< Pulses for servos that turn on and on.
};

/// Bits of `ConfigureWiring::bridge_options`.
enum BridgeOptions : uint8_t {
  kBrakeAtZero = 1U << 0,  ///< A wheel at duty 0 is braked instead of left to coast.
  kSlowPwm = 1U << 1,      ///< About 1 kHz instead of 8 kHz, for bridges of bipolar transistors.
};

/// How motors and bump contacts are connected. A robot of before version 1.3 has phase/enable
/// bridges and contacts that close, and no such message.
struct ConfigureWiring {
  enum : uint8_t { kId = 0x1A };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "ConfigureWiring"; }
  uint8_t command_id;
  uint8_t bridge;                    ///< A MotorBridgeKind.
  uint8_t bridge_options;            ///< BridgeOptions.
  uint8_t contacts_normally_closed;  ///< Those that open when they are pressed: 1 left, 2 right.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("bridge", m.bridge);
    v("bridge_options", m.bridge_options);
    v("contacts_normally_closed", m.contacts_normally_closed);
  }
};

/// How often Scalar comes, of the sensor on the spare pin whose function is kPinScalarLevel or
/// kPinScalarPulses. A robot of before version 1.4 has no such sensor and no such message.
struct ConfigureScalar {
  enum : uint8_t { kId = 0x1B };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "ConfigureScalar"; }
  uint8_t command_id;
  uint16_t period_ms;  ///< 0: never.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("period_ms", m.period_ms);
  }
};

/// Wheel speeds, until the next one or until the time to live is over.
struct DriveSetpoint {
  enum : uint8_t { kId = 0x20 };
  static constexpr MessageClass message_class() { return MessageClass::kSetpoint; }
  static constexpr const char* name() { return "DriveSetpoint"; }
  int16_t left_ticks_per_s;
  int16_t right_ticks_per_s;
  uint16_t time_to_live_ms;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("left_ticks_per_s", m.left_ticks_per_s);
    v("right_ticks_per_s", m.right_ticks_per_s);
    v("time_to_live_ms", m.time_to_live_ms);
  }
};

/// The host is still there: the wheels may go on for this long.
struct KeepAlive {
  enum : uint8_t { kId = 0x21 };
  static constexpr MessageClass message_class() { return MessageClass::kSetpoint; }
  static constexpr const char* name() { return "KeepAlive"; }
  uint16_t time_to_live_ms;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("time_to_live_ms", m.time_to_live_ms);
  }
};

}  // namespace protocol
}  // namespace echomap
