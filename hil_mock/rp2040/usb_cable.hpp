// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace echomap::rp2040 {

/// How a USB device answers a transaction.
enum class UsbAnswer : std::uint8_t { kNone, kAck, kNak, kStall };

/// An IN token's answer.
struct UsbData {
  UsbAnswer answer = UsbAnswer::kNone;
  bool data1 = false;
  std::vector<std::uint8_t> bytes;
};

/// Whether a device's controller has noticed that its host has resumed the bus.
enum class UsbResume : std::uint8_t { kNoticed, kMissed };

/// The wires to a full-speed USB device, as its host's controller sees them.
class UsbCable {
 public:
  virtual ~UsbCable() = default;

  /// Puts the plug in or takes it out.
  virtual void plug(bool plugged) = 0;
  /// Whether the device shows its pull-up.
  virtual bool is_attached() const = 0;
  /// Whether an IN to the bulk endpoint would get anything but a NAK.
  virtual bool has_bulk_in() const = 0;
  virtual void reset_bus() = 0;
  /// No frames, as of a host that sleeps, and frames again.
  virtual void suspend_bus() = 0;
  virtual void resume_bus(UsbResume resume) = 0;
  /// A SETUP transaction of eight bytes to endpoint 0.
  virtual UsbAnswer setup(std::uint8_t address, std::span<const std::uint8_t> packet) = 0;
  virtual UsbData in(std::uint8_t address, std::uint8_t endpoint) = 0;
  virtual UsbAnswer out(std::uint8_t address,
                        std::uint8_t endpoint,
                        bool data1,
                        std::span<const std::uint8_t> bytes) = 0;
};

}  // namespace echomap::rp2040
