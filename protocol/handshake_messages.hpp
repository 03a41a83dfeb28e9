// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/message_schema.hpp"

namespace echomap {
namespace protocol {

/// Why the board last started; bits of HelloReply::reset_cause.
enum ResetCause : uint8_t {
  kResetPowerOn = 1U << 0,
  kResetExternal = 1U << 1,
  kResetBrownOut = 1U << 2,
  kResetWatchdog = 1U << 3,
};

/// What the board has; bits of HelloReply::capabilities.
enum Capability : uint32_t {
  kCapabilityWheels = 1UL << 0,         ///< Two wheels with encoders: MoveTicks, DriveSetpoint.
  kCapabilityPanSonar = 1UL << 1,       ///< A sonar on a pan drive: StartSweep.
  kCapabilityContacts = 1UL << 2,       ///< Bump contacts.
  kCapabilityPins = 1UL << 3,           ///< Spare pins: ConfigurePins, hazards.
  kCapabilityRanges = 1UL << 4,         ///< Analogue range channels.
  kCapabilityGyro = 1UL << 5,           ///< An MPU-6050 may be connected.
  kCapabilityStepper = 1UL << 6,        ///< The pan may be a stepper.
  kCapabilityBlindEncoders = 1UL << 7,  ///< They cannot tell a lost count: no EncoderErrors.
  kCapabilityScalar = 1UL << 8,         ///< A spare pin may be a scalar sensor: Scalar.
};

/// Answer to a command, in Ack::status.
enum class CommandStatus : uint8_t {
  kAccepted = 0,
  kDisarmed = 1,    ///< Motion needs Arm first, any command a Hello.
  kBusy = 2,        ///< A move or sweep is under way.
  kOutOfRange = 3,  ///< A field is outside of what the board can do.
  kBlocked = 4,  ///< A pressed contact or a hazard forbids to go forward, a hanging wheel to arm.
};

/// Host to robot, every 50 ms until answered. A new `session` forgets earlier command ids. While
/// another session holds the robot, HelloReply names that one, and nothing else happens.
struct Hello {
  enum : uint8_t { kId = 0x01 };
  static constexpr MessageClass message_class() { return MessageClass::kHandshake; }
  static constexpr const char* name() { return "Hello"; }
  uint8_t protocol_major;
  uint8_t protocol_minor;
  uint32_t schema_digest;
  uint16_t session;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("protocol_major", m.protocol_major);
    v("protocol_minor", m.protocol_minor);
    v("schema_digest", m.schema_digest);
    v("session", m.session);
  }
};

/// Robot to host: who answers, since which reset, and what it can take.
struct HelloReply {
  enum : uint8_t { kId = 0x02 };
  static constexpr MessageClass message_class() { return MessageClass::kHandshake; }
  static constexpr const char* name() { return "HelloReply"; }
  uint8_t protocol_major;
  uint8_t protocol_minor;
  uint32_t schema_digest;
  uint16_t firmware_version;
  uint16_t boot_id;
  uint8_t reset_cause;
  uint16_t session;
  uint16_t tick_hz;
  uint16_t receive_credit_bytes;
  uint32_t capabilities;
  uint32_t config_digest;  ///< Of the configuration that now holds, see config_digest.hpp.

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("protocol_major", m.protocol_major);
    v("protocol_minor", m.protocol_minor);
    v("schema_digest", m.schema_digest);
    v("firmware_version", m.firmware_version);
    v("boot_id", m.boot_id);
    v("reset_cause", m.reset_cause);
    v("session", m.session);
    v("tick_hz", m.tick_hz);
    v("receive_credit_bytes", m.receive_credit_bytes);
    v("capabilities", m.capabilities);
    v("config_digest", m.config_digest);
  }
};

/// Host to robot: a Hello for a robot that another session holds, which ends that one.
struct TakeOver {
  enum : uint8_t { kId = 0x06 };
  static constexpr MessageClass message_class() { return MessageClass::kHandshake; }
  static constexpr const char* name() { return "TakeOver"; }
  uint16_t session;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("session", m.session);
  }
};

/// Robot to host: the command `command_id` has been done or refused.
struct Ack {
  enum : uint8_t { kId = 0x03 };
  static constexpr MessageClass message_class() { return MessageClass::kHandshake; }
  static constexpr const char* name() { return "Ack"; }
  uint8_t command_id;
  uint8_t status;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_id", m.command_id);
    v("status", m.status);
  }
};

/// Host to robot: answered by Pong with the same token.
struct Ping {
  enum : uint8_t { kId = 0x04 };
  static constexpr MessageClass message_class() { return MessageClass::kHandshake; }
  static constexpr const char* name() { return "Ping"; }
  uint32_t token;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("token", m.token);
  }
};

/// Robot to host.
struct Pong {
  enum : uint8_t { kId = 0x05 };
  static constexpr MessageClass message_class() { return MessageClass::kHandshake; }
  static constexpr const char* name() { return "Pong"; }
  uint32_t token;
  uint32_t stamp_us;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("token", m.token);
    v("stamp_us", m.stamp_us);
  }
};

}  // namespace protocol
}  // namespace echomap
