// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/boards/rp2040/usb_descriptors.hpp"
#include "firmware/boards/rp2040/usb_protocol.hpp"

namespace echomap {
namespace boards {
namespace usb {

/// What endpoint 0 is to do next.
enum class Next : uint8_t {
  kWait,     ///< Nothing until the host begins another transfer.
  kSend,     ///< A packet, maybe of no bytes.
  kReceive,  ///< A packet.
  kStall,    ///< Refuse: the device does not know the request.
};

/// What a request changes outside of endpoint 0.
enum class Effect : uint8_t {
  kNone,
  kAddress,    ///< `address()` from now on.
  kConfigure,  ///< All other endpoints start again, or with configuration 0 are off.
  kHalt,       ///< One endpoint was halted or set going again: see `halted`.
};

/// A step of a control transfer.
struct Step {
  Next next;
  Effect effect;
  Bytes packet;      ///< Of kSend.
  uint8_t endpoint;  ///< Of kHalt, as in its descriptor.
};

/// The control transfers of the serial port, USB 2.0 chapter 9 and CDC: what the device answers on
/// endpoint 0, without a register of it. Packets alternate, beginning with DATA1 after each SETUP;
/// that is the caller's.
class ControlTransfers {
 public:
  /// The host has reset the bus: no address, no configuration, no port open.
  void on_bus_reset() { *this = ControlTransfers(); }
  /// A SETUP came; whatever was under way is over.
  Step on_setup(const uint8_t (&setup)[8]);
  /// The packet of kSend has gone.
  Step on_sent();
  /// The packet of kReceive has come.
  Step on_received(Bytes packet);

  uint8_t address() const { return address_; }
  bool is_configured() const { return configuration_ != 0; }
  /// True while a program on the host has the port open.
  bool is_open() const { return is_configured() && terminal_ready_; }
  /// True for an endpoint, as in its descriptor, that the host has halted.
  bool halted(uint8_t endpoint) const;

 private:
  /// A SETUP, USB 2.0 table 9-2.
  struct Request {
    uint8_t type, request;
    uint16_t value, index, length;
  };
  enum class Stage : uint8_t { kIdle, kSendData, kSendStatus, kReceiveData, kReceiveStatus };

  Step standard(const Request& request);
  Step to_device(const Request& request);
  Step to_interface(const Request& request);
  Step to_endpoint(const Request& request);
  Step to_port(const Request& request);
  Step answer(const Request& request, Bytes bytes);
  Step answer(const Request& request, uint8_t first, uint8_t second, uint8_t size);
  Step acknowledge(Effect effect = Effect::kNone, uint8_t endpoint = 0);
  Step send_packet();
  Step refuse();
  uint8_t* halt_of(uint16_t endpoint);

  Stage stage_ = Stage::kIdle;
  Bytes left_{nullptr, 0};        ///< To send yet.
  bool ends_with_empty_ = false;  ///< The host expects more than there is.
  uint8_t address_ = 0;
  uint8_t next_address_ = 0;
  uint8_t configuration_ = 0;
  bool terminal_ready_ = false;
  uint8_t halts_[3] = {0, 0, 0};  ///< Notification, data to the host, data to the device.
  uint8_t reply_[2] = {0, 0};
  uint8_t line_coding_[kLineCodingBytes] = {0x90, 0xD0, 0x03, 0, 0, 0, 8};  ///< 250000, 8N1.
};

}  // namespace usb
}  // namespace boards
}  // namespace echomap
