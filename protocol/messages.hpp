// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/bulk_messages.hpp"
#include "protocol/command_messages.hpp"
#include "protocol/handshake_messages.hpp"
#include "protocol/telemetry_messages.hpp"

/// Every message of the wire. The list of fields in a message's `each` is the only place that knows
/// them: size, seed, encoding, decoding and description are visitors of it.
/// Angles are centidegrees counter-clockwise, times the robot's own microseconds, wheels encoder
/// counts ("ticks"); the host turns them into SI units in host/sensors.
namespace echomap {
namespace protocol {

/// Who receives which message; every message is in one of the two and in AllMessages.
using MessagesToRobot = MessageList<Hello,
                                    Ping,
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
                                    BulkRead>;
using MessagesToHost = MessageList<HelloReply,
                                   Ack,
                                   Pong,
                                   BulkData,
                                   Odometry,
                                   Echo,
                                   Status,
                                   Health,
                                   Ranges,
                                   Gyro,
                                   EncoderErrors,
                                   Scalar>;
using AllMessages = MessageList<Hello,
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
                                Scalar>;

/// Digest of the whole schema, the same on both sides when they were built from the same messages.
template <class List>
struct DigestOf {
  enum : uint32_t { kValue = List::digest() };
};
constexpr uint32_t kSchemaDigest = DigestOf<AllMessages>::kValue;

}  // namespace protocol
}  // namespace echomap
