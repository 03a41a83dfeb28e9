// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tuple>

#include "host/ros_messages/cdr_error.hpp"
#include "host/ros_messages/field_types.hpp"

namespace echomap::ros_messages {

/// The fewest bytes that a field of this type takes, padding left out.
template <class T>
std::size_t min_cdr_size() {
  if constexpr (Primitive<T>) {
    return sizeof(T);
  } else if constexpr (FixedArray<T>) {
    return std::tuple_size_v<T> * min_cdr_size<typename T::value_type>();
  } else if constexpr (Message<T>) {
    static const std::size_t size = [] {
      std::size_t sum = 0;
      const auto add = [&sum]<class Field>(std::string_view /*name*/, const Field& /*value*/) {
        sum += min_cdr_size<Field>();
      };
      const T empty{};
      T::fields(empty, add);
      return sum;
    }();
    return size;
  } else {
    return sizeof(std::uint32_t);  // The count of an empty text or sequence.
  }
}

/// Reads fields of the Common Data Representation (CdrWriter says which), of either byte order. It
/// throws CdrError where a field is not there as its type says, and takes no more memory than the
/// bytes left can fill.
class CdrReader {
 public:
  /// `bytes` with the header of 4; the name of the message's type is for errors.
  CdrReader(std::span<const std::uint8_t> bytes, std::string_view message_name);

  /// Reads one field; the name is for errors.
  template <class T>
  void operator()(std::string_view name, T& value) {
    field_name_ = name;
    read(value);
  }

 private:
  template <class T>
  void read(T& value) {
    if constexpr (Message<T>) {
      T::fields(value, *this);
    } else if constexpr (Sequence<T>) {
      value.clear();
      value.resize(read_count(min_cdr_size<typename T::value_type>()));
      read_elements(value);
    } else if constexpr (FixedArray<T>) {
      read_elements(value);
    } else if constexpr (std::same_as<T, bool>) {
      value = read_bool();
    } else if constexpr (Primitive<T>) {
      read_numbers(&value, 1, sizeof(T));
    } else {
      read_text(value);
    }
  }

  template <class T>
  void read_elements(T& values) {
    using Element = typename T::value_type;
    static_assert(!std::same_as<Element, bool>, "a vector of bool has no elements in memory");
    if constexpr (Primitive<Element>) {
      read_numbers(values.data(), values.size(), sizeof(Element));
    } else {
      for (Element& element : values) {
        read(element);
      }
    }
  }

  void read_numbers(void* numbers, std::size_t count, std::size_t size);
  /// The count of a sequence whose elements take `element_size` bytes or more.
  std::size_t read_count(std::size_t element_size);
  bool read_bool();
  void read_text(std::string& text);
  [[noreturn]] void fail(const std::string& reason) const;

  /// What follows the header, and how much of it was read.
  std::span<const std::uint8_t> body_;
  std::size_t at_ = 0;
  bool is_swapped_ = false;
  std::string_view message_name_;
  std::string_view field_name_;
};

}  // namespace echomap::ros_messages
