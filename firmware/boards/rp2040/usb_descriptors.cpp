// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/usb_descriptors.hpp"

#include "firmware/boards/rp2040/usb_protocol.hpp"

namespace echomap {
namespace boards {
namespace usb {
namespace {

/// A serial port in the way of the class for modems: an interface that is told what the line is
/// like, one for the bytes. Its protocol is 0, no AT commands, so that no modem manager asks.
constexpr uint8_t kCommunications = 2;
constexpr uint8_t kAbstractControlModel = 2;
constexpr uint8_t kDataClass = 10;
constexpr uint8_t kMiscellaneous = 0xEF;

constexpr uint8_t kDeviceDescriptor[] = {
    18,
    kDevice,
    0x00,
    0x02,  // USB 2.0
    kMiscellaneous,
    2,
    1,  // Interfaces belong together: see the association.
    kControlPacketBytes,
    0x8A,
    0x2E,  // Raspberry Pi
    0x0A,
    0x00,  // A program on a Pico that is a serial port.
    0x00,
    0x01,  // Version 1.0
    1,
    2,
    3,  // Strings: maker, product, serial number.
    1,  // Configuration.
};

constexpr uint8_t kConfigurationBytes = 75;
constexpr uint8_t kBusPowered = 0x80;
constexpr uint8_t kUnitsOf2Ma = 50;
constexpr uint8_t kInterruptTransfer = 3;
constexpr uint8_t kBulkTransfer = 2;

constexpr uint8_t kConfigurationDescriptor[] = {
    9,
    kConfiguration,
    kConfigurationBytes,
    0,
    2,
    1,
    0,
    kBusPowered,
    kUnitsOf2Ma,
    // Both interfaces are one function.
    8,
    kInterfaceAssociation,
    kControlInterface,
    2,
    kCommunications,
    kAbstractControlModel,
    0,
    0,
    // What the line is like.
    9,
    kInterface,
    kControlInterface,
    0,
    1,
    kCommunications,
    kAbstractControlModel,
    0,
    0,
    5,
    kClassInterface,
    0,
    0x20,
    0x01,  // CDC 1.2
    5,
    kClassInterface,
    1,
    0,
    kDataInterface,  // Call management: none.
    4,
    kClassInterface,
    2,
    2,  // Line coding and line state.
    5,
    kClassInterface,
    6,
    kControlInterface,
    kDataInterface,
    7,
    kEndpoint,
    kToHost | kNotificationEndpoint,
    kInterruptTransfer,
    kNotificationPacketBytes,
    0,
    255,  // ms
    // The bytes.
    9,
    kInterface,
    kDataInterface,
    0,
    2,
    kDataClass,
    0,
    0,
    0,
    7,
    kEndpoint,
    kDataEndpoint,
    kBulkTransfer,
    kBulkPacketBytes,
    0,
    0,
    7,
    kEndpoint,
    kToHost | kDataEndpoint,
    kBulkTransfer,
    kBulkPacketBytes,
    0,
    0,
};
static_assert(sizeof(kDeviceDescriptor) == 18, "its own first byte");
static_assert(sizeof(kConfigurationDescriptor) == kConfigurationBytes, "its own third byte");

constexpr uint8_t kLanguages[] = {4, kString, 0x09, 0x04};  // US English.

/// A string descriptor: 16 bits a character.
template <uint8_t kLength>
struct StringDescriptor {
  uint8_t bytes[2 + 2 * kLength];

  constexpr explicit StringDescriptor(const char (&text)[kLength + 1]) : bytes() {
    bytes[0] = sizeof(bytes);
    bytes[1] = kString;
    for (uint8_t i = 0; i < kLength; ++i) {
      bytes[2 + 2 * i] = static_cast<uint8_t>(text[i]);
    }
  }
};

constexpr StringDescriptor<7> kMaker("echomap");
constexpr StringDescriptor<12> kProduct("echomap Pico");
constexpr StringDescriptor<1> kSerialNumber("1");

template <uint8_t kSize>
constexpr Bytes all_of(const uint8_t (&bytes)[kSize]) {
  return {bytes, kSize};
}

Bytes string(uint8_t index) {
  switch (index) {
    case 0:
      return all_of(kLanguages);
    case 1:
      return all_of(kMaker.bytes);
    case 2:
      return all_of(kProduct.bytes);
    case 3:
      return all_of(kSerialNumber.bytes);
    default:
      return {nullptr, 0};
  }
}

}  // namespace

Bytes descriptor(uint8_t type, uint8_t index) {
  if (type == kString) {
    return string(index);
  }
  if (type == kDevice && index == 0) {
    return all_of(kDeviceDescriptor);
  }
  if (type == kConfiguration && index == 0) {
    return all_of(kConfigurationDescriptor);
  }
  return {nullptr, 0};
}

}  // namespace usb
}  // namespace boards
}  // namespace echomap
