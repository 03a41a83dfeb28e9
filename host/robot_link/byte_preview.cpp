// SPDX-License-Identifier: MIT
#include "host/robot_link/byte_preview.hpp"

#include <algorithm>

namespace echomap::robot_link {
namespace {

constexpr std::size_t kBytesPerLine = 16;

std::string line_of(std::span<const std::uint8_t> bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string hexadecimal;
  std::string printable;
  for (const std::uint8_t byte : bytes) {
    hexadecimal += {kDigits[byte >> 4], kDigits[byte & 0xF], ' '};
    printable += byte >= 0x20 && byte < 0x7F ? static_cast<char>(byte) : '.';
  }
  hexadecimal.resize(3 * kBytesPerLine, ' ');
  return hexadecimal + " |" + printable + "|\n";
}

}  // namespace

void BytePreview::add(std::uint8_t byte) {
  if (bytes_.size() < kMaxBytes) {
    bytes_.push_back(byte);
  }
}

std::string BytePreview::text() const {
  std::string text;
  for (std::size_t at = 0; at < bytes_.size(); at += kBytesPerLine) {
    text += line_of(bytes().subspan(at, std::min(kBytesPerLine, bytes_.size() - at)));
  }
  return text;
}

}  // namespace echomap::robot_link
