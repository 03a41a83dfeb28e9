// SPDX-License-Identifier: MIT
#include "host/exports/png_text.hpp"

#include <cstdint>
#include <string_view>
#include <zlib.h>

namespace echomap::exports {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kTextType = "tEXt";
/// A chunk is its length, its type, as many bytes as the length says, and a CRC of type and bytes.
constexpr std::size_t kLengthBytes = 4;
constexpr std::size_t kTypeBytes = 4;
constexpr std::size_t kCrcBytes = 4;
constexpr std::size_t kAroundBytes = kLengthBytes + kTypeBytes + kCrcBytes;
/// The first chunk, IHDR, has 13.
constexpr std::size_t kHeaderEnd = kSignature.size() + kAroundBytes + 13;

void append_big_endian(std::string& bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) {
    bytes.push_back(static_cast<char>(value >> shift & 0xFFU));
  }
}

std::string chunk_of(const PngText& text) {
  const std::string content = text.key + '\0' + text.text;
  const std::string checked = std::string(kTextType) + content;
  std::string chunk;
  append_big_endian(chunk, static_cast<std::uint32_t>(content.size()));
  chunk += checked;
  append_big_endian(
      chunk,
      static_cast<std::uint32_t>(::crc32(
          0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()))));
  return chunk;
}

}  // namespace

void add_png_texts(std::vector<unsigned char>& png, const std::vector<PngText>& texts) {
  std::string chunks;
  for (const PngText& text : texts) {
    chunks += chunk_of(text);
  }
  png.insert(png.begin() + kHeaderEnd, chunks.begin(), chunks.end());
}

}  // namespace echomap::exports
