// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "protocol/messages.hpp"
#include "protocol/schema_description.hpp"

/// Messages of firmware that is older or newer than this host.
namespace echomap::robot_link {

/// An Odometry that tells a third wheel.
struct NewOdometry {
  enum : std::uint8_t { kId = protocol::Odometry::kId };
  static constexpr protocol::MessageClass message_class() {
    return protocol::MessageClass::kTelemetry;
  }
  static constexpr const char* name() { return "Odometry"; }
  std::uint32_t stamp_us;
  std::int16_t left_ticks;
  std::int16_t right_ticks;
  std::int16_t third_ticks;
  std::uint8_t flags;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("stamp_us", m.stamp_us);
    v("left_ticks", m.left_ticks);
    v("right_ticks", m.right_ticks);
    v("third_ticks", m.third_ticks);
    v("flags", m.flags);
  }
};

/// A Health with one counter less.
struct OldHealth {
  enum : std::uint8_t { kId = protocol::Health::kId };
  static constexpr protocol::MessageClass message_class() {
    return protocol::MessageClass::kTelemetry;
  }
  static constexpr const char* name() { return "Health"; }
  std::uint32_t stamp_us;
  std::uint16_t frames_bad;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("stamp_us", m.stamp_us);
    v("frames_bad", m.frames_bad);
  }
};

/// A message that this host has never heard of.
struct Compass {
  enum : std::uint8_t { kId = 0x60 };
  static constexpr protocol::MessageClass message_class() {
    return protocol::MessageClass::kTelemetry;
  }
  static constexpr const char* name() { return "Compass"; }
  std::uint32_t stamp_us;
  std::int16_t heading_cdeg;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("stamp_us", m.stamp_us);
    v("heading_cdeg", m.heading_cdeg);
  }
};

namespace other_messages {
using namespace protocol;  // NOLINT(google-build-using-namespace): names of a long list

/// Firmware 1.0 of a kind: no ranges, no gyro, a smaller Health.
using Older = MessageList<Hello,
                          HelloReply,
                          Ack,
                          Ping,
                          Pong,
                          Arm,
                          Stop,
                          ConfigureDrive,
                          ConfigureSonar,
                          MoveTicks,
                          StartSweep,
                          ConfigurePan,
                          ConfigurePins,
                          ConfigureSensors,
                          ConfigureSafety,
                          KeepAlive,
                          BulkRead,
                          BulkData,
                          Odometry,
                          Echo,
                          Status,
                          OldHealth>;
/// Firmware 1.2: nothing of how motors and contacts are wired, of encoder errors and take-overs.
using BeforeWiring = MessageList<Hello,
                                 HelloReply,
                                 Ack,
                                 Ping,
                                 Pong,
                                 Arm,
                                 Stop,
                                 ConfigureDrive,
                                 ConfigureSonar,
                                 MoveTicks,
                                 StartSweep,
                                 ConfigurePan,
                                 ConfigurePins,
                                 ConfigureSensors,
                                 ConfigureSafety,
                                 DriveSetpoint,
                                 KeepAlive,
                                 BulkRead,
                                 BulkData,
                                 Odometry,
                                 Echo,
                                 Status,
                                 Health,
                                 Ranges,
                                 Gyro>;
/// Firmware 1.3: nothing of a scalar sensor.
using BeforeScalar = MessageList<Hello,
                                 HelloReply,
                                 Ack,
                                 Ping,
                                 Pong,
                                 TakeOver,
                                 Arm,
                                 Stop,
                                 ConfigureDrive,
                                 ConfigureSonar,
                                 MoveTicks,
                                 StartSweep,
                                 ConfigurePan,
                                 ConfigurePins,
                                 ConfigureSensors,
                                 ConfigureSafety,
                                 ConfigureWiring,
                                 DriveSetpoint,
                                 KeepAlive,
                                 BulkRead,
                                 BulkData,
                                 Odometry,
                                 Echo,
                                 Status,
                                 Health,
                                 Ranges,
                                 Gyro,
                                 EncoderErrors>;
/// Firmware with all of ours and one more.
using Newer = MessageList<Hello,
                          HelloReply,
                          Ack,
                          Ping,
                          Pong,
                          TakeOver,
                          Arm,
                          Stop,
                          ConfigureDrive,
                          ConfigureSonar,
                          MoveTicks,
                          StartSweep,
                          ConfigurePan,
                          ConfigurePins,
                          ConfigureSensors,
                          ConfigureSafety,
                          ConfigureWiring,
                          ConfigureScalar,
                          DriveSetpoint,
                          KeepAlive,
                          BulkRead,
                          BulkData,
                          Odometry,
                          Echo,
                          Status,
                          Health,
                          Ranges,
                          Gyro,
                          EncoderErrors,
                          Scalar,
                          Compass>;
/// Firmware whose Odometry is another.
using Foreign = MessageList<Hello, HelloReply, BulkRead, BulkData, NewOdometry>;
}  // namespace other_messages

template <class List>
std::vector<std::uint8_t> description_of() {
  constexpr auto kDescription = protocol::describe_schema<List>();
  return {std::begin(kDescription.bytes), std::end(kDescription.bytes)};
}

}  // namespace echomap::robot_link
