// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "host/fleet_messages/content_hash.hpp"
#include "host/fleet_messages/field_types.hpp"

namespace echomap::fleet_messages {

/// A visitor that appends a message's fields to bytes, in the encoding of docs/fleet_protocol.md.
/// Values that a reader would refuse are written nevertheless, and `fits` is then false.
class FieldWriter {
 public:
  explicit FieldWriter(std::string& bytes) : bytes_(bytes) {}

  /// A whole number, little-endian.
  template <std::integral T>
  void operator()(std::string_view /*name*/, const T& value, std::uint64_t max = kAnyValue<T>) {
    const auto number = static_cast<std::make_unsigned_t<T>>(value);
    fits_ = fits_ && number <= max;
    put(number, sizeof(T));
  }
  /// A robot's name: its length, then its characters.
  void operator()(std::string_view /*name*/, const std::string& text);
  void operator()(std::string_view /*name*/, const ContentHash& hash);
  void operator()(std::string_view name, const std::vector<ContentHash>& hashes);
  template <TableRow Row>
  void operator()(std::string_view /*name*/, const std::vector<Row>& rows) {
    put_count(rows.size());
    for (std::size_t column = 0; column < column_count<Row>(); ++column) {
      put_column(rows, column);
    }
  }
  template <MessagePart Part>
  void operator()(std::string_view /*name*/, const Part& part) {
    Part::fields(part, *this);
  }
  template <MessagePart Part>
  void operator()(std::string_view /*name*/, const std::vector<Part>& parts) {
    put_count(parts.size());
    for (const Part& part : parts) {
      Part::fields(part, *this);
    }
  }

  /// Whether a reader accepts all that was written so far.
  bool fits() const { return fits_; }

 private:
  template <TableRow Row>
  void put_column(const std::vector<Row>& rows, std::size_t column) {
    std::uint32_t above = 0;
    auto put_difference = [&]<class T>(const T& value, std::uint64_t max) {
      using Unsigned = std::make_unsigned_t<T>;
      const auto number = static_cast<Unsigned>(value);
      fits_ = fits_ && number <= max;
      put_signed(static_cast<std::make_signed_t<T>>(static_cast<Unsigned>(number - above)));
      above = number;
    };
    for (const Row& row : rows) {
      ColumnVisitor visitor(column, put_difference);
      Row::fields(row, visitor);
    }
  }

  void put(std::uint64_t value, std::size_t size);
  void put_count(std::size_t count);
  /// Zigzag and base 128: 1 byte from -64 to 63, 2 bytes from -8192 to 8191.
  void put_signed(std::int32_t value);

  std::string& bytes_;
  bool fits_ = true;
};

}  // namespace echomap::fleet_messages
