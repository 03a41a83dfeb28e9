// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "firmware/hal/twi.hpp"

namespace echomap {
namespace native {

/// The native board's two-wire bus: its devices are functions, its transfers take the time of 400
/// kbit/s.
class NativeTwoWire {
 public:
  /// A START and an address that nobody answers; then a STOP.
  static constexpr std::int64_t kRefusedNs = 27500;
  /// START, three bytes of 9 bits, STOP.
  static constexpr std::int64_t kWriteNs = 72500;
  /// START, two bytes, START, three bytes, STOP.
  static constexpr std::int64_t kReadNs = 120000;

  /// The big-endian word in registers `device_register` and the next of the device with this 7-bit
  /// address; none where no device answers. Called when the transfer starts.
  std::function<std::optional<std::int16_t>(std::uint8_t address, std::uint8_t device_register)>
      on_read;
  /// Takes a value into a register of a device; false where no device answers.
  std::function<bool(std::uint8_t address, std::uint8_t device_register, std::uint8_t value)>
      on_write;
  /// While true a device holds the clock: transfers begin and never end.
  bool held = false;

  /// What the functions of firmware/hal/twi.hpp do at `now_ns`.
  void start_write(std::int64_t now_ns,
                   std::uint8_t address,
                   std::uint8_t device_register,
                   std::uint8_t value);
  void start_read(std::int64_t now_ns, std::uint8_t address, std::uint8_t device_register);
  hal::TwiState state(std::int64_t now_ns, std::int16_t& value) const;
  void stop() { state_ = hal::TwiState::kIdle; }

 private:
  void end(std::int64_t end_ns, bool answered);

  hal::TwiState state_ = hal::TwiState::kIdle;
  std::int64_t end_ns_ = 0;
  std::int16_t value_ = 0;
};

}  // namespace native
}  // namespace echomap
