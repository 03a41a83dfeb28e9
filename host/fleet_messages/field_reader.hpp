// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "host/fleet_messages/content_hash.hpp"
#include "host/fleet_messages/field_types.hpp"
#include "host/fleet_messages/refused_reason.hpp"

namespace echomap::fleet_messages {

/// A visitor that reads what FieldWriter writes, and accepts nothing else. After the first refusal
/// fields stay as they are. It takes no more memory than the bytes left can fill.
class FieldReader {
 public:
  explicit FieldReader(std::string_view bytes) : bytes_(bytes) {}

  template <std::integral T>
  void operator()(std::string_view /*name*/, T& value, std::uint64_t max = kAnyValue<T>) {
    const auto number = static_cast<std::make_unsigned_t<T>>(read(sizeof(T)));
    if (number > max) {
      refuse(RefusedReason::kOutOfRange);
    }
    value = static_cast<T>(number);
  }
  void operator()(std::string_view /*name*/, std::string& text);
  void operator()(std::string_view /*name*/, ContentHash& hash);
  void operator()(std::string_view name, std::vector<ContentHash>& hashes);
  template <TableRow Row>
  void operator()(std::string_view /*name*/, std::vector<Row>& rows) {
    rows.resize(read_count(column_count<Row>()));
    for (std::size_t column = 0; column < column_count<Row>() && !refused_; ++column) {
      read_column(rows, column);
    }
  }
  template <MessagePart Part>
  void operator()(std::string_view /*name*/, Part& part) {
    Part::fields(part, *this);
  }
  template <MessagePart Part>
  void operator()(std::string_view /*name*/, std::vector<Part>& parts) {
    parts.resize(read_count(1));
    for (Part& part : parts) {
      Part::fields(part, *this);
    }
  }

  /// Reads all bytes that are left.
  std::string_view take_rest() { return take(bytes_.size()); }
  /// Why the bytes are not a valid message, after its last field; empty where they are.
  std::optional<RefusedReason> finish();

 private:
  template <TableRow Row>
  void read_column(std::vector<Row>& rows, std::size_t column) {
    std::uint32_t above = 0;
    auto read_difference = [&]<class T>(T& value, std::uint64_t max) {
      using Unsigned = std::make_unsigned_t<T>;
      const auto difference = static_cast<Unsigned>(read_signed(8 * sizeof(T)));
      const auto number = static_cast<Unsigned>(above + difference);
      if (number > max) {
        refuse(RefusedReason::kOutOfRange);
      }
      value = static_cast<T>(number);
      above = number;
    };
    for (Row& row : rows) {
      ColumnVisitor visitor(column, read_difference);
      Row::fields(row, visitor);
    }
  }

  std::uint64_t read(std::size_t size);
  /// Reads a number of at most `bits` bits, whose encoding must be the shortest one.
  std::int32_t read_signed(unsigned bits);
  /// Reads the number of elements that take `element_bytes` or more each.
  std::size_t read_count(std::size_t element_bytes);
  /// The next bytes; none where there are fewer.
  std::string_view take(std::size_t size);
  void refuse(RefusedReason reason);

  std::string_view bytes_;
  std::optional<RefusedReason> refused_;
};

}  // namespace echomap::fleet_messages
