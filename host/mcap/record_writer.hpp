// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string_view>

#include "host/mcap/crc32.hpp"
#include "host/mcap/file_layout.hpp"
#include "host/mcap/records.hpp"

namespace echomap::mcap {

/// Writes `value` over the bytes at `position`, the lowest byte first.
template <std::unsigned_integral T>
void overwrite_number(Bytes& out, std::size_t position, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    out[position + i] = static_cast<std::uint8_t>(value >> (8 * i));
  }
}

/// Appends `value`, the lowest byte first. The type of `value` says how many bytes it takes.
template <std::unsigned_integral T>
void append_number(Bytes& out, T value) {
  out.resize(out.size() + sizeof(T));
  overwrite_number(out, out.size() - sizeof(T), value);
}

/// Appends one record to a block of bytes. The record is whole when the writer is destroyed, which
/// fills in its length.
class RecordWriter {
 public:
  RecordWriter(Bytes& out, Opcode opcode) : out_(out) {
    append_number(out_, static_cast<std::uint8_t>(opcode));
    append_number(out_, std::uint64_t{0});
    content_start_ = out_.size();
  }
  ~RecordWriter() {
    overwrite_number(out_,
                     content_start_ - sizeof(std::uint64_t),
                     static_cast<std::uint64_t>(out_.size() - content_start_));
  }
  RecordWriter(const RecordWriter&) = delete;
  RecordWriter& operator=(const RecordWriter&) = delete;

  template <std::unsigned_integral T>
  void number(T value) {
    append_number(out_, value);
  }
  /// Appends bytes without their count.
  void bytes(std::span<const std::uint8_t> block) {
    out_.insert(out_.end(), block.begin(), block.end());
  }
  /// Appends a text after its length, four bytes.
  void text(std::string_view text) {
    number(length_of(text.size()));
    out_.insert(out_.end(), text.begin(), text.end());
  }
  /// Appends what `append_entry` writes of each entry, after the count of bytes of all, four bytes.
  template <class Entries, class AppendEntry>
  void list(const Entries& entries, const AppendEntry& append_entry) {
    const std::size_t length_at = out_.size();
    number(std::uint32_t{0});
    for (const auto& entry : entries) {
      append_entry(entry);
    }
    overwrite_number(out_, length_at, length_of(out_.size() - length_at - sizeof(std::uint32_t)));
  }
  /// Appends a list of pairs of name and text.
  void text_map(const TextMap& map) {
    list(map, [this](const auto& entry) {
      text(entry.first);
      text(entry.second);
    });
  }
  /// CRC-32 of the content so far.
  std::uint32_t crc() const { return crc32_of(std::span(out_).subspan(content_start_)); }

 private:
  static std::uint32_t length_of(std::size_t bytes) {
    if (bytes > std::numeric_limits<std::uint32_t>::max()) {
      throw std::length_error("a text or list of an MCAP record has at most 4294967295 bytes");
    }
    return static_cast<std::uint32_t>(bytes);
  }

  Bytes& out_;
  std::size_t content_start_ = 0;
};

}  // namespace echomap::mcap
