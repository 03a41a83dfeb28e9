// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace echomap::mqtt {

/// Why there is no connection, or why a message was refused.
enum class Reason : std::uint8_t {
  kNone,
  // Reported by the broker (MQTT 5, section 2.4).
  kWrongPassword,  ///< CONNACK 0x86 or 0x87: user or password is not known there.
  kNotAuthorized,  ///< 0x87 to a message: its topic is not this user's to write.
  kTooLarge,       ///< 0x95.
  kTakenOver,      ///< 0x8E: another client has connected as this one.
  kShuttingDown,   ///< 0x8B.
  kQuotaExceeded,  ///< 0x97.
  kProtocolError,  ///< 0x81 or 0x82.
  kRefused,        ///< Any other code of an error.
  // Observed of the connection.
  kUnknownHost,
  kUnreachable,       ///< Nothing listens there, or no network leads there.
  kTlsFailed,         ///< The certificate is not of this CA or host, or it is no TLS port.
  kClosedUnanswered,  ///< Closed before the broker has answered: it may want TLS.
  kSilent,            ///< No answer within the keep-alive time or to the first packet.
  kLost,
};

/// Reason for a code of MQTT 5 in an acknowledgement or in a DISCONNECT; kNone below 0x80.
Reason reason_of_code(int code);

/// Reason for a code of a CONNACK.
Reason reason_of_connack(int code);

/// Text of a reason for messages to people, without a full stop.
std::string_view text_of(Reason reason);

}  // namespace echomap::mqtt
