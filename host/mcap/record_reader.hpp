// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "host/mcap/records.hpp"

namespace echomap::mcap {

/// The bytes of a record contradict the format; what() says how, without the file and the place.
class RecordError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A name from a file for a message to people: at most 40 characters, and none that a terminal acts
/// on.
inline std::string printable_name(const std::string& name) {
  std::string printable = name.substr(0, 40);
  for (char& character : printable) {
    const auto code = static_cast<unsigned char>(character);
    character = code < 0x20 || code > 0x7E ? '?' : character;
  }
  return printable;
}

/// Takes the content of a record apart, from its front. Throws RecordError where a field is longer
/// than what is left. Bytes after the last known field are allowed: a later writer may add fields.
class RecordReader {
 public:
  explicit RecordReader(std::span<const std::uint8_t> content) : rest_(content) {}

  std::span<const std::uint8_t> rest() const { return rest_; }

  /// Takes a number off, the lowest byte first.
  template <std::unsigned_integral T>
  T number() {
    T value = 0;
    std::size_t shift = 0;
    for (const std::uint8_t byte : bytes(sizeof(T))) {
      value = static_cast<T>(value | static_cast<T>(static_cast<T>(byte) << shift));
      shift += 8;
    }
    return value;
  }
  std::span<const std::uint8_t> bytes(std::uint64_t count) {
    if (count > rest_.size()) {
      throw RecordError("a field of " + std::to_string(count) + " bytes in a record that has " +
                        std::to_string(rest_.size()) + " left");
    }
    const auto taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }
  /// Takes a text off that follows its length, four bytes.
  std::string text() {
    const auto block = bytes(number<std::uint32_t>());
    return {block.begin(), block.end()};
  }
  /// Takes a list of pairs of name and text off. Of two equal names the later one counts.
  TextMap text_map() {
    RecordReader entries(bytes(number<std::uint32_t>()));
    TextMap map;
    while (!entries.rest().empty()) {
      std::string name = entries.text();
      map.insert_or_assign(std::move(name), entries.text());
    }
    return map;
  }

 private:
  std::span<const std::uint8_t> rest_;
};

}  // namespace echomap::mcap
