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

/// Allows (1) or forbids (0) motion; forbidding stops at once.
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

/// Pan servo and sonar of the robot's profile.
struct ConfigureSonar {
  enum : uint8_t { kId = 0x13 };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "ConfigureSonar"; }
  uint8_t command_id;
  uint16_t pan_centre_us;    ///< Servo pulse that looks straight ahead.
  int16_t pan_us_per_90deg;  ///< Change of the pulse for 90 degrees to the left.
  int16_t pan_min_cdeg;
  int16_t pan_max_cdeg;
  uint16_t pan_deg_per_s;  ///< Speed of the servo, for the wait before a reading.
  uint16_t max_echo_us;    ///< A later echo counts as none.
  uint8_t ping_gap_ms;     ///< Least time from one ping to the next.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("pan_centre_us", m.pan_centre_us);
    v("pan_us_per_90deg", m.pan_us_per_90deg);
    v("pan_min_cdeg", m.pan_min_cdeg);
    v("pan_max_cdeg", m.pan_max_cdeg);
    v("pan_deg_per_s", m.pan_deg_per_s);
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

/// Reads the sonar at from, from + step, .. up to and including `to`, after `settle_ms` at each.
struct StartSweep {
  enum : uint8_t { kId = 0x15 };
  static constexpr MessageClass message_class() { return MessageClass::kCommand; }
  static constexpr const char* name() { return "StartSweep"; }
  uint8_t command_id;
  int16_t from_cdeg;
  int16_t to_cdeg;
  int16_t step_cdeg;
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

/// The host is still there: whatever moves may go on for this long.
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
