// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "hil_mock/rp2040/control_pipe.hpp"
#include "hil_mock/rp2040/usb_cable.hpp"

namespace echomap::rp2040 {

/// A host like Linux with its cdc_acm: enumerates what is plugged in, opens the serial port, and
/// carries its bytes. It is driven by `service`, one transaction a time.
class UsbHost {
 public:
  explicit UsbHost(UsbCable& cable) : cable_(cable), control_(cable) {}

  /// Does what is due at `now_ns` and returns when it wants to be called next.
  std::int64_t service(std::int64_t now_ns);

  void plug(bool plugged, std::int64_t now_ns);
  /// Resets the bus and enumerates the device again.
  void reset(std::int64_t now_ns);
  /// Falls asleep with the port open, until it wakes, is plugged or resets the bus.
  void suspend();
  void resume(UsbResume resume);
  /// Bytes for the device; kept until the port is open and the device takes them; lost where the
  /// cable is out.
  void send(std::span<const std::uint8_t> bytes);
  std::size_t waiting_bytes() const { return outgoing_.size(); }
  /// Called with each byte that the device has sent.
  std::function<void(std::uint8_t)> on_byte;

  /// Sends a control transfer of the caller's after enumeration; `on_end` gets the outcome.
  void request(const UsbRequest& request,
               std::vector<std::uint8_t> data,
               std::function<void(const UsbTransfer&)> on_end);

  /// Whether the serial port is open: configured, DTR set.
  bool is_open() const { return open_; }
  /// Whether nothing goes over the cable but INs that the device does not answer, one a frame.
  bool only_polls() const {
    return open_ && !suspended_ && control_.is_idle() && outgoing_.empty() &&
           cable_.is_attached() && !cable_.has_bulk_in();
  }
  /// What was read in the enumeration.
  const std::vector<std::uint8_t>& device_descriptor() const { return device_; }
  const std::vector<std::uint8_t>& configuration() const { return configuration_; }
  const std::vector<std::string>& strings() const { return strings_; }
  /// Number of enumerations that were begun.
  unsigned enumerations() const { return enumerations_; }

 private:
  void begin_enumeration(std::int64_t now_ns);
  void ask(const UsbRequest& request, std::function<void(const UsbTransfer&)> on_end);
  void read_configuration();
  void read_strings();
  void set_up_line();
  void give_up();
  void step_control(std::int64_t now_ns);
  bool step_bulk();
  bool reads_bulk();
  bool writes_bulk();

  UsbCable& cable_;
  ControlPipe control_;
  bool plugged_ = false;
  bool seen_ = false;
  bool open_ = false;
  bool suspended_ = false;
  bool configured_ = false;
  std::uint8_t next_address_ = 1;
  unsigned enumerations_ = 0;
  unsigned attempts_ = 0;
  std::int64_t wait_until_ns_ = 0;
  std::vector<std::uint8_t> device_;
  std::vector<std::uint8_t> configuration_;
  std::vector<std::string> strings_;
  std::deque<std::uint8_t> outgoing_;
  bool in_data1_ = false;
  bool out_data1_ = false;
};

}  // namespace echomap::rp2040
