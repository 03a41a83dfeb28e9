// SPDX-License-Identifier: MIT
#include "host/ros_messages/cdr_reader.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace echomap::ros_messages {
namespace {

constexpr std::size_t kCdrHeaderBytes = 4;
/// The second byte of the header; the first is 0.
constexpr std::uint8_t kPlainBigEndian = 0;
constexpr std::uint8_t kPlainLittleEndian = 1;

}  // namespace

CdrReader::CdrReader(std::span<const std::uint8_t> bytes, std::string_view message_name)
    : message_name_(message_name), field_name_("header") {
  if (bytes.size() < kCdrHeaderBytes) {
    fail("the header has " + std::to_string(bytes.size()) + " of 4 bytes");
  }
  if (bytes[0] != 0 || bytes[1] > kPlainLittleEndian) {
    fail("representation " + std::to_string(bytes[0] * 256 + bytes[1]) +
         " is not plain CDR, which is 0 or 1");
  }
  constexpr bool kIsLittle = std::endian::native == std::endian::little;
  is_swapped_ = bytes[1] == (kIsLittle ? kPlainBigEndian : kPlainLittleEndian);
  body_ = bytes.subspan(kCdrHeaderBytes);
}

void CdrReader::read_numbers(void* numbers, std::size_t count, std::size_t size) {
  if (count == 0) {
    return;
  }
  const std::size_t begin = (at_ + size - 1) / size * size;
  if (begin > body_.size() || (body_.size() - begin) / size < count) {
    fail("the message ends after " + std::to_string(body_.size()) + " bytes, within this field");
  }
  auto* first = static_cast<std::uint8_t*>(numbers);
  std::memcpy(first, &body_[begin], count * size);
  if (is_swapped_ && size > 1) {
    for (std::size_t i = 0; i < count; ++i) {
      std::reverse(first + i * size, first + (i + 1) * size);
    }
  }
  at_ = begin + count * size;
}

std::size_t CdrReader::read_count(std::size_t element_size) {
  std::uint32_t count = 0;
  read_numbers(&count, 1, sizeof(count));
  if (count > (body_.size() - at_) / element_size) {
    fail(std::to_string(count) + " elements cannot be in the " +
         std::to_string(body_.size() - at_) + " bytes that are left");
  }
  return count;
}

bool CdrReader::read_bool() {
  std::uint8_t value = 0;
  read_numbers(&value, 1, 1);
  if (value > 1) {
    fail(std::to_string(value) + " is not a truth value");
  }
  return value == 1;
}

void CdrReader::read_text(std::string& text) {
  const std::size_t count = read_count(1);
  if (count == 0) {
    text.clear();  // Some writers leave out the zero of an empty text.
    return;
  }
  const auto characters = body_.subspan(at_, count);
  if (characters.back() != 0) {
    fail("the text has no zero at its end");
  }
  text.assign(characters.begin(), characters.end() - 1);
  at_ += count;
}

void CdrReader::fail(const std::string& reason) const {
  throw CdrError(std::string(message_name_) + ", " + std::string(field_name_) + ": " + reason);
}

}  // namespace echomap::ros_messages
