// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

/// Words of the USB 2.0 specification (chapter 9) and of its class for modems (CDC 1.2, PSTN 1.2)
/// that the device uses.
namespace echomap {
namespace boards {
namespace usb {

/// Bits of bmRequestType.
constexpr uint8_t kToHost = 0x80;
constexpr uint8_t kTypeMask = 0x60;
constexpr uint8_t kStandard = 0x00;
constexpr uint8_t kClass = 0x20;
constexpr uint8_t kRecipientMask = 0x1F;
constexpr uint8_t kOfDevice = 0;
constexpr uint8_t kOfInterface = 1;
constexpr uint8_t kOfEndpoint = 2;

/// bRequest of the standard requests.
enum StandardRequest : uint8_t {
  kGetStatus = 0,
  kClearFeature = 1,
  kSetFeature = 3,
  kSetAddress = 5,
  kGetDescriptor = 6,
  kGetConfiguration = 8,
  kSetConfiguration = 9,
  kGetInterface = 10,
  kSetInterface = 11,
};

/// bRequest of the class.
enum ClassRequest : uint8_t {
  kSetLineCoding = 0x20,
  kGetLineCoding = 0x21,
  kSetControlLineState = 0x22,
};

/// bDescriptorType.
enum DescriptorType : uint8_t {
  kDevice = 1,
  kConfiguration = 2,
  kString = 3,
  kInterface = 4,
  kEndpoint = 5,
  kInterfaceAssociation = 11,
  kClassInterface = 0x24,
};

/// ENDPOINT_HALT, the feature of an endpoint.
constexpr uint16_t kHaltFeature = 0;
constexpr uint16_t kDataTerminalReady = 1;  ///< Bit of SET_CONTROL_LINE_STATE.
constexpr uint8_t kLineCodingBytes = 7;
constexpr uint8_t kControlPacketBytes = 64;
constexpr uint8_t kBulkPacketBytes = 64;
constexpr uint8_t kNotificationPacketBytes = 8;

/// The endpoints of this device.
constexpr uint8_t kNotificationEndpoint = 1;
constexpr uint8_t kDataEndpoint = 2;
constexpr uint8_t kControlInterface = 0;
constexpr uint8_t kDataInterface = 1;

}  // namespace usb
}  // namespace boards
}  // namespace echomap
