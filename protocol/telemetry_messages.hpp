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
  kFlagHazard = 1U << 5,  ///< One of Status::hazards that stops the wheels.
};

/// Bits of `hazards` in Status and of ConfigureSafety::hazard_stops.
enum Hazard : uint8_t {
  kHazardCliffLeft = 1U << 0,
  kHazardCliffFrontLeft = 1U << 1,
  kHazardCliffFrontRight = 1U << 2,
  kHazardCliffRight = 1U << 3,
  kHazardWheelDrop = 1U << 4,  ///< A wheel hangs: the robot was lifted or drives over an edge.
  kHazardVirtualWall = 1U << 5,
  kHazardWall = 1U << 6,
};

/// How a move or a sweep stands, in Status.
enum class MotionOutcome : uint8_t {
  kNone = 0,  ///< None was started since the reset.
  kRunning = 1,
  kReached = 2,
  kBumped = 3,   ///< Stopped by a bump contact.
  kExpired = 4,  ///< Stopped because the host fell silent: time to live, kMaxSweepSilenceMs.
  kStopped = 5,  ///< Stopped by Stop, by Arm{0}, a new session or a newer set-point.
  /// The wheels did not follow. If set-points drove them, none does anything from then on before
  /// one of zero speed, a Stop or an Arm.
  kStalled = 6,
  kHazard = 7,      ///< Stopped by a hazard of ConfigureSafety::hazard_stops.
  kLifted = 8,      ///< Stopped and disarmed by a wheel-drop: the pose is not to be trusted.
  kRunaway = 9,     ///< Stopped and disarmed: a wheel turned against its command.
  kOverSpeed = 10,  ///< Stopped and disarmed: a wheel was faster than allowed.
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

/// `Echo::flight_us` of a ping without an echo in range: the sonar has listened in vain.
constexpr uint16_t kNoEcho = 0xFFFF;
/// `Echo::flight_us` of a ping whose trigger the sonar did not answer, as one that is dead or not
/// connected.
constexpr uint16_t kNoSonar = 0xFFFE;
/// Firmware of an earlier minor version sends kNoEcho for kNoSonar, too.
constexpr uint8_t kNoSonarSinceMinor = 2;

/// Robot to host: one sonar reading with the wheel counts and pan at the moment of the ping.
struct Echo {
  enum : uint8_t { kId = 0x41 };
  static constexpr MessageClass message_class() { return MessageClass::kTelemetry; }
  static constexpr const char* name() { return "Echo"; }
  uint32_t stamp_us;
  int16_t pan_cdeg;
  uint16_t flight_us;  ///< There and back, or kNoEcho or kNoSonar.
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

/// Robot to host: how the last move and sweep stand; five times a second and at once when one of
/// the outcomes or hazards changes.
struct Status {
  enum : uint8_t { kId = 0x42 };
  static constexpr MessageClass message_class() { return MessageClass::kTelemetry; }
  static constexpr const char* name() { return "Status"; }
  uint32_t stamp_us;
  uint8_t flags;
  uint8_t hazards;
  uint8_t move_id;
  uint8_t move_outcome;
  uint8_t sweep_id;
  uint8_t sweep_outcome;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("stamp_us", m.stamp_us);
    v("flags", m.flags);
    v("hazards", m.hazards);
    v("move_id", m.move_id);
    v("move_outcome", m.move_outcome);
    v("sweep_id", m.sweep_id);
    v("sweep_outcome", m.sweep_outcome);
  }
};

/// Robot to host, once a second: the board's counters since the reset, modulo 2^16.
struct Health {
  enum : uint8_t { kId = 0x43 };
  static constexpr MessageClass message_class() { return MessageClass::kTelemetry; }
  static constexpr const char* name() { return "Health"; }
  uint32_t stamp_us;
  uint16_t frames_bad;
  uint16_t frames_lost;
  uint16_t receive_overruns;
  uint16_t telemetry_dropped;
  uint16_t encoder_errors;    ///< Of both wheels: see EncoderErrors.
  uint16_t stack_free_bytes;  ///< Least free stack so far, by paint; 0: not known yet.
  uint16_t battery_raw;       ///< Converter counts, 0 .. 1023; 0 where no pin measures it.
  uint8_t rate_step;  ///< Telemetry periods are stretched by 2 to this power: the line is slow.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("stamp_us", m.stamp_us);
    v("frames_bad", m.frames_bad);
    v("frames_lost", m.frames_lost);
    v("receive_overruns", m.receive_overruns);
    v("telemetry_dropped", m.telemetry_dropped);
    v("encoder_errors", m.encoder_errors);
    v("stack_free_bytes", m.stack_free_bytes);
    v("battery_raw", m.battery_raw);
    v("rate_step", m.rate_step);
  }
};

/// Robot to host, with every Health once one is not 0: edges at which both pins of a wheel had
/// changed at once, so that counts are lost; since the reset, modulo 2^16.
struct EncoderErrors {
  enum : uint8_t { kId = 0x46 };
  static constexpr MessageClass message_class() { return MessageClass::kTelemetry; }
  static constexpr const char* name() { return "EncoderErrors"; }
  uint32_t stamp_us;
  uint16_t left;
  uint16_t right;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("stamp_us", m.stamp_us);
    v("left", m.left);
    v("right", m.right);
  }
};

/// `channel_N` of Ranges that no pin reads.
constexpr uint16_t kNoRange = 0xFFFF;

/// Robot to host: converter counts (0 .. 1023) of the infra-red range channels, each read in the
/// 10 ms before, and the wheel counts of the moment.
struct Ranges {
  enum : uint8_t { kId = 0x44 };
  static constexpr MessageClass message_class() { return MessageClass::kTelemetry; }
  static constexpr const char* name() { return "Ranges"; }
  uint32_t stamp_us;
  int16_t left_ticks;
  int16_t right_ticks;
  uint16_t channel_0;
  uint16_t channel_1;
  uint16_t channel_2;
  uint16_t channel_3;
  uint16_t channel_4;
  uint16_t channel_5;
  uint16_t channel_6;
  uint16_t channel_7;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("stamp_us", m.stamp_us);
    v("left_ticks", m.left_ticks);
    v("right_ticks", m.right_ticks);
    v("channel_0", m.channel_0);
    v("channel_1", m.channel_1);
    v("channel_2", m.channel_2);
    v("channel_3", m.channel_3);
    v("channel_4", m.channel_4);
    v("channel_5", m.channel_5);
    v("channel_6", m.channel_6);
    v("channel_7", m.channel_7);
  }
};

/// Robot to host: the gyro's rate about the vertical axis, summed up since the reset, so that a
/// lost frame costs no angle.
struct Gyro {
  enum : uint8_t { kId = 0x45 };
  static constexpr MessageClass message_class() { return MessageClass::kTelemetry; }
  static constexpr const char* name() { return "Gyro"; }
  uint32_t stamp_us;
  int32_t yaw_sum;   ///< Sum of the raw samples, modulo 2^32, counter-clockwise positive.
  uint16_t samples;  ///< Modulo 2^16, one each ConfigureSensors::gyro_period_ms.
  uint16_t errors;   ///< Samples the bus did not bring, modulo 2^16; the last good one stands in.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("stamp_us", m.stamp_us);
    v("yaw_sum", m.yaw_sum);
    v("samples", m.samples);
    v("errors", m.errors);
  }
};

/// Robot to host: what the scalar sensor has said since the reset, so that a lost frame costs no
/// pulse and no conversion, and the wheel counts of the moment.
struct Scalar {
  enum : uint8_t { kId = 0x47 };
  static constexpr MessageClass message_class() { return MessageClass::kTelemetry; }
  static constexpr const char* name() { return "Scalar"; }
  uint32_t stamp_us;
  int16_t left_ticks;
  int16_t right_ticks;
  uint32_t sum;      ///< Pulses, or the sum of the conversions (0 .. 1023), modulo 2^32.
  uint16_t samples;  ///< Conversions in the sum, modulo 2^16; pulses do not count here.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("stamp_us", m.stamp_us);
    v("left_ticks", m.left_ticks);
    v("right_ticks", m.right_ticks);
    v("sum", m.sum);
    v("samples", m.samples);
  }
};

}  // namespace protocol
}  // namespace echomap
