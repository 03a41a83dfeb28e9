// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace echomap::runner {

/// The device's end of a byte stream to a host: a pty or a TCP port. No call ever waits.
class ByteEndpoint {
 public:
  virtual ~ByteEndpoint() = default;

  /// The bytes that have come since the last call.
  virtual std::vector<std::uint8_t> receive() = 0;
  /// Sends, after what is still on its way.
  virtual void send(std::span<const std::uint8_t> bytes) = 0;
  /// What a host takes as `--port`.
  virtual std::string address() const = 0;
  /// Readable when `receive` has something to do.
  virtual int descriptor() const = 0;
  /// Whether bytes are still on their way; `send` with nothing pushes on.
  virtual bool is_sending() const = 0;
  /// Bytes that nobody has read and that are lost.
  virtual std::uint64_t dropped_bytes() const = 0;
};

}  // namespace echomap::runner
