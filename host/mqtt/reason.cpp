// SPDX-License-Identifier: MIT
#include "host/mqtt/reason.hpp"

#include <mqtt_protocol.h>

namespace echomap::mqtt {

Reason reason_of_code(int code) {
  constexpr int kFirstError = 0x80;
  if (code < kFirstError) {
    return Reason::kNone;
  }
  switch (code) {
    case MQTT_RC_NOT_AUTHORIZED:
      return Reason::kNotAuthorized;
    case MQTT_RC_PACKET_TOO_LARGE:
      return Reason::kTooLarge;
    case MQTT_RC_SESSION_TAKEN_OVER:
      return Reason::kTakenOver;
    case MQTT_RC_SERVER_SHUTTING_DOWN:
      return Reason::kShuttingDown;
    case MQTT_RC_QUOTA_EXCEEDED:
      return Reason::kQuotaExceeded;
    case MQTT_RC_KEEP_ALIVE_TIMEOUT:
      return Reason::kSilent;
    case MQTT_RC_MALFORMED_PACKET:
    case MQTT_RC_PROTOCOL_ERROR:
      return Reason::kProtocolError;
    default:
      return Reason::kRefused;
  }
}

Reason reason_of_connack(int code) {
  switch (code) {
    case CONNACK_ACCEPTED:
      return Reason::kNone;
    case CONNACK_REFUSED_BAD_USERNAME_PASSWORD:
    case CONNACK_REFUSED_NOT_AUTHORIZED:
    case MQTT_RC_BAD_USERNAME_OR_PASSWORD:
    case MQTT_RC_NOT_AUTHORIZED:
      return Reason::kWrongPassword;
    default: {
      const Reason reason = reason_of_code(code);
      return reason == Reason::kNone ? Reason::kRefused : reason;
    }
  }
}

std::string_view text_of(Reason reason) {
  switch (reason) {
    case Reason::kNone:
      return "no error";
    case Reason::kWrongPassword:
      return "the broker does not accept this user or password";
    case Reason::kNotAuthorized:
      return "this user may not write this topic";
    case Reason::kTooLarge:
      return "the message is larger than the broker takes";
    case Reason::kTakenOver:
      return "another client has connected under the same name";
    case Reason::kShuttingDown:
      return "the broker is shutting down";
    case Reason::kQuotaExceeded:
      return "the broker's quota is used up";
    case Reason::kProtocolError:
      return "the broker cannot read what was sent";
    case Reason::kRefused:
      return "the broker refuses";
    case Reason::kUnknownHost:
      return "the host's name is not known";
    case Reason::kUnreachable:
      return "no broker listens there";
    case Reason::kTlsFailed:
      return "no TLS connection: the certificate is not of this CA or for this host, or the port "
             "is "
             "plain";
    case Reason::kClosedUnanswered:
      return "the connection was closed without an answer: the port may want TLS";
    case Reason::kSilent:
      return "the broker does not answer";
    case Reason::kLost:
      return "the connection was lost";
  }
  return "";
}

}  // namespace echomap::mqtt
