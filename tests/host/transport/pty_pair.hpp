// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "host/transport/byte_stream.hpp"
#include "host/transport/file_descriptor.hpp"

namespace echomap::transport {

/// The device's end of a pseudo terminal, as an emulated robot holds it: raw, with the slave side
/// kept open so that hosts may come and go.
class PtyPair {
 public:
  PtyPair();

  /// Path of the end that a host opens.
  const std::string& name() const { return name_; }
  int fd() const { return master_->get(); }
  void write(std::span<const std::uint8_t> bytes);
  /// Waits for `count` bytes; fewer after five seconds.
  std::vector<std::uint8_t> read(std::size_t count);
  /// How many bytes of a host nobody has read yet; waits some 20 ms for the first of them.
  std::size_t unread_bytes() const;
  /// The device dies.
  void unplug();

 private:
  std::unique_ptr<FileDescriptor> master_;
  std::unique_ptr<FileDescriptor> slave_;
  std::string name_;
};

/// Reads until `count` bytes have come, the stream is closed or five seconds are over.
std::vector<std::uint8_t> read_bytes(ByteStream& stream, std::size_t count);

/// The bytes 0, 1, .. 255, 0, ..: everything that a tty could meddle with.
std::vector<std::uint8_t> counting_bytes(std::size_t count);

}  // namespace echomap::transport
