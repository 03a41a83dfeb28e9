// SPDX-License-Identifier: MIT
#include "tests/support/png_texts.hpp"

#include <cstdint>
#include <string>
#include <string_view>

#include "host/files/atomic_file.hpp"

namespace echomap::tests {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kTextType = "tEXt";
/// A chunk is its length, its type, as many bytes as the length says, and a CRC of type and bytes.
constexpr std::size_t kLengthBytes = 4;
constexpr std::size_t kTypeBytes = 4;
constexpr std::size_t kCrcBytes = 4;
constexpr std::size_t kAroundBytes = kLengthBytes + kTypeBytes + kCrcBytes;

std::uint32_t big_endian_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < kLengthBytes; ++i) {
    value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  }
  return value;
}

}  // namespace

std::vector<exports::PngText> read_png_texts(const std::filesystem::path& path) {
  const std::string bytes = files::read_text_file(path);
  if (!bytes.starts_with(kSignature)) {
    throw files::FileError(path.string() + ": not a PNG file");
  }
  std::vector<exports::PngText> texts;
  for (std::size_t at = kSignature.size(); at < bytes.size();) {
    const std::size_t left = bytes.size() - at;
    if (left < kAroundBytes || big_endian_at(bytes, at) > left - kAroundBytes) {
      throw files::FileError(path.string() + ": the file ends within a chunk");
    }
    const std::size_t length = big_endian_at(bytes, at);
    const std::string content = bytes.substr(at + kLengthBytes + kTypeBytes, length);
    const std::size_t zero = content.find('\0');
    if (bytes.compare(at + kLengthBytes, kTypeBytes, kTextType) == 0 && zero != std::string::npos) {
      texts.push_back({content.substr(0, zero), content.substr(zero + 1)});
    }
    at += kAroundBytes + length;
  }
  return texts;
}

}  // namespace echomap::tests
