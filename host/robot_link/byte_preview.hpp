// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace echomap::robot_link {

/// Keeps the first bytes that came on a port where frames were expected, to show what came instead.
class BytePreview {
 public:
  static constexpr std::size_t kMaxBytes = 64;

  void add(std::uint8_t byte);
  void clear() { bytes_.clear(); }
  std::span<const std::uint8_t> bytes() const { return bytes_; }

  /// Two columns of 16 bytes a line, hexadecimal and printable, as hexdump shows them.
  std::string text() const;

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace echomap::robot_link
