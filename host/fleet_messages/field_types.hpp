// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "host/fleet_messages/content_hash.hpp"

namespace echomap::fleet_messages {

/// A row of a table: a struct of whole numbers of 32 bits or fewer, with `kIsRow` and a static
/// template `fields(self, visit)` that calls `visit("name", self.name)` or, where not every number
/// of the type is allowed, `visit("name", self.name, max)`. A table is sent column by column, each
/// number as its difference from the one above.
template <class T>
concept TableRow = requires { requires T::kIsRow; };

/// A part of a message that has fields of its own, and is sent field by field.
template <class T>
concept MessagePart = requires { requires T::kIsPart; };

/// Largest number of rows of a table and of elements of a list.
inline constexpr std::size_t kMaxElements = 8192;

/// Largest value of a field that accepts all values of its type.
template <std::integral T>
inline constexpr std::uint64_t kAnyValue = std::numeric_limits<std::make_unsigned_t<T>>::max();

/// Number of columns of a table with such rows.
template <TableRow Row>
constexpr std::size_t column_count() {
  std::size_t count = 0;
  const auto add = [&count]<class T>(std::string_view /*name*/,
                                     const T& /*value*/,
                                     std::uint64_t /*max*/ = kAnyValue<T>) { ++count; };
  const Row row{};
  Row::fields(row, add);
  return count;
}

/// Calls `use(value, max)` for one column of a row.
template <class Use>
class ColumnVisitor {
 public:
  ColumnVisitor(std::size_t column, Use& use) : left_(column), use_(use) {}

  template <std::integral T>
  void operator()(std::string_view /*name*/, T& value, std::uint64_t max = kAnyValue<T>) {
    if (left_-- == 0) {
      use_(value, max);
    }
  }
  template <std::integral T>
  void operator()(std::string_view /*name*/, const T& value, std::uint64_t max = kAnyValue<T>) {
    if (left_-- == 0) {
      use_(value, max);
    }
  }

 private:
  std::size_t left_;
  Use& use_;
};

}  // namespace echomap::fleet_messages
