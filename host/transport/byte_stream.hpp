// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace echomap::transport {

/// Whether bytes can still pass.
enum class StreamStatus : std::uint8_t {
  kOpen,
  kAway,    ///< Gone for now; it is opened again as soon as it is back.
  kClosed,  ///< For good; `close_reason()` says why.
};

/// Bytes to and from a robot, whatever carries them. Nothing throws after construction: an
/// unplugged cable or a dead peer ends in kClosed. One thread at a time.
class ByteStream {
 public:
  virtual ~ByteStream() = default;

  /// Reads what is there, or waits up to `wait` for the first byte; 0 after `wait` or when closed.
  virtual std::size_t read_some(std::span<std::uint8_t> into, std::chrono::microseconds wait) = 0;

  /// Hands all bytes to the system. A peer that takes none for a second closes the stream; a closed
  /// or away stream drops them.
  virtual void write(std::span<const std::uint8_t> bytes) = 0;

  virtual StreamStatus status() const = 0;
  /// Why the stream is closed or away, for people; empty while it is open.
  virtual std::string close_reason() const = 0;
  /// What the user called it: a device path or a tcp:// address.
  virtual std::string name() const = 0;
  /// Changes the speed of the open line, bits per second, and nothing else of it; false where it
  /// has none (a pty, TCP, Bluetooth) or does not take this one.
  virtual bool set_baud(int /*baud*/) { return false; }
  /// How often it was away and came back.
  virtual std::uint64_t reconnects() const { return 0; }
};

}  // namespace echomap::transport
