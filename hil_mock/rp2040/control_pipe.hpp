// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "hil_mock/rp2040/usb_cable.hpp"

namespace echomap::rp2040 {

/// The first eight bytes of a control transfer.
struct UsbRequest {
  std::uint8_t type;
  std::uint8_t request;
  std::uint16_t value;
  std::uint16_t index;
  std::uint16_t length;
};

/// How a control transfer has ended.
struct UsbTransfer {
  enum class End : std::uint8_t { kDone, kStalled, kNoAnswer, kTimeout };
  End end = End::kNoAnswer;
  std::vector<std::uint8_t> bytes;
};

/// A host's end of a device's endpoint 0: control transfers one behind the other.
class ControlPipe {
 public:
  explicit ControlPipe(UsbCable& cable) : cable_(cable) {}

  /// Queues a transfer; `on_end` gets the outcome.
  void request(const UsbRequest& request,
               std::vector<std::uint8_t> data,
               std::function<void(const UsbTransfer&)> on_end);
  /// The device is new: address 0, short packets, and no transfer.
  void clear();
  /// The address to which it speaks.
  void set_address(std::uint8_t address) { address_ = address; }
  std::uint8_t address() const { return address_; }
  /// The most bytes of a packet.
  void set_max_packet(std::uint8_t bytes) { max_packet_ = bytes; }

  bool is_idle() const { return transfers_.empty(); }
  /// The next transaction is the last one of SET_ADDRESS.
  bool is_setting_address() const;
  /// One transaction of the transfer that is under way; false where that was given up instead.
  bool step(std::int64_t now_ns);

 private:
  enum class Stage : std::uint8_t { kSetup, kData, kStatus };

  struct Transfer {
    UsbRequest request;
    std::vector<std::uint8_t> data;
    std::function<void(const UsbTransfer&)> on_end;
    Stage stage = Stage::kSetup;
    bool data1 = true;
    std::size_t sent = 0;
    std::int64_t until_ns = 0;
  };

  void step_data();
  void step_status();
  void end(UsbTransfer::End how);

  UsbCable& cable_;
  std::uint8_t address_ = 0;
  std::uint8_t max_packet_ = 8;
  std::deque<Transfer> transfers_;
  std::vector<std::uint8_t> received_;
};

}  // namespace echomap::rp2040
