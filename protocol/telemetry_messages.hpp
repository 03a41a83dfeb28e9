// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/message_schema.hpp"

namespace echomap {
namespace protocol {

/// Bits of `flags` in Odometry and Status.
enum RobotFlags : uint8_t {
  kFlagArmed = 1U << 0,
  kFlagMoving = 1U << 1,
  kFlagSweeping = 1U << 2,
  kFlagBumpLeft = 1U << 3,
  kFlagBumpRight = 1U << 4,
};

/// How a move or a sweep stands, in Status.
enum class MotionOutcome : uint8_t {
  kNone = 0,  ///< None was started since the reset.
  kRunning = 1,
  kReached = 2,
  kBumped = 3,   ///< Stopped by a bump contact.
  kExpired = 4,  ///< Stopped because the host fell silent: time to live.
  kStopped = 5,  ///< Stopped by Stop, by Arm{0} or by a newer set-point.
  kStalled = 6,  ///< The wheels did not follow.
};

/// Robot to host: wheel counts since the reset, modulo 2^16.
struct Odometry {
  enum : uint8_t { kId = 0x40 };
  static constexpr MessageClass message_class() { return MessageClass::kTelemetry; }
  static constexpr const char* name() { return "Odometry"; }
  uint32_t stamp_us;
  int16_t left_ticks;
  int16_t right_ticks;
  uint8_t flags;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("stamp_us", m.stamp_us);
    v("left_ticks", m.left_ticks);
    v("right_ticks", m.right_ticks);
    v("flags", m.flags);
  }
};

/// `Echo::flight_us` of a ping that nothing answered.
constexpr uint16_t kNoEcho = 0xFFFF;

/// Robot to host: one sonar reading with the wheel counts and pan at the moment of the ping.
struct Echo {
  enum : uint8_t { kId = 0x41 };
  static constexpr MessageClass message_class() { return MessageClass::kTelemetry; }
  static constexpr const char* name() { return "Echo"; }
  uint32_t stamp_us;
  int16_t pan_cdeg;
  uint16_t flight_us;  ///< There and back, or kNoEcho.
  int16_t left_ticks;
  int16_t right_ticks;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("stamp_us", m.stamp_us);
    v("pan_cdeg", m.pan_cdeg);
    v("flight_us", m.flight_us);
    v("left_ticks", m.left_ticks);
    v("right_ticks", m.right_ticks);
  }
};

/// Robot to host: how the last move and sweep stand, and the board's counters; five times a second
/// and at once when an outcome changes.
struct Status {
  enum : uint8_t { kId = 0x42 };
  static constexpr MessageClass message_class() { return MessageClass::kTelemetry; }
  static constexpr const char* name() { return "Status"; }
  uint32_t stamp_us;
  uint8_t flags;
  uint8_t move_id;
  uint8_t move_outcome;
  uint8_t sweep_id;
  uint8_t sweep_outcome;
  uint16_t frames_bad;
  uint16_t frames_lost;
  uint16_t receive_overruns;
  uint16_t telemetry_dropped;
  uint16_t encoder_errors;
  uint16_t stack_free_bytes;  ///< Least free stack so far, by paint; 0: not known yet.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("stamp_us", m.stamp_us);
    v("flags", m.flags);
    v("move_id", m.move_id);
    v("move_outcome", m.move_outcome);
    v("sweep_id", m.sweep_id);
    v("sweep_outcome", m.sweep_outcome);
    v("frames_bad", m.frames_bad);
    v("frames_lost", m.frames_lost);
    v("receive_overruns", m.receive_overruns);
    v("telemetry_dropped", m.telemetry_dropped);
    v("encoder_errors", m.encoder_errors);
    v("stack_free_bytes", m.stack_free_bytes);
  }
};

}  // namespace protocol
}  // namespace echomap
