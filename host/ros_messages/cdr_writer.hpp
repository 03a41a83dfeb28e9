// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host/ros_messages/field_types.hpp"

namespace echomap::ros_messages {

/// Writes fields in the Common Data Representation that ROS 2 sends and records (OMG DDS-XTypes
/// 1.3, section 7.4: XCDR version 1, plain, little endian). A number begins at a multiple of its
/// own size, counted from the end of the header of 4 bytes.
class CdrWriter {
 public:
  static constexpr std::size_t kHeaderBytes = 4;

  /// Empties `bytes`, which keeps its memory and has to outlive the writer, and writes the header.
  explicit CdrWriter(std::vector<std::uint8_t>& bytes);

  /// Writes one field; the name is not part of the representation.
  template <class T>
  void operator()(std::string_view /*name*/, const T& value) {
    write(value);
  }

 private:
  template <class T>
  void write(const T& value) {
    if constexpr (Message<T>) {
      T::fields(value, *this);
    } else if constexpr (Sequence<T>) {
      write_count(value.size());
      write_elements(value);
    } else if constexpr (FixedArray<T>) {
      write_elements(value);
    } else if constexpr (Primitive<T>) {
      write_numbers(&value, 1, sizeof(T));
    } else {
      write_text(value);
    }
  }

  template <class T>
  void write_elements(const T& values) {
    using Element = typename T::value_type;
    if constexpr (Primitive<Element>) {
      write_numbers(values.data(), values.size(), sizeof(Element));
    } else {
      for (const Element& element : values) {
        write(element);
      }
    }
  }

  /// Appends `count` numbers of `size` bytes each; nothing, not even padding, where there are none.
  void write_numbers(const void* numbers, std::size_t count, std::size_t size);
  /// Throws CdrError where a count does not fit into 32 bits.
  void write_count(std::size_t count);
  void write_text(std::string_view text);

  std::vector<std::uint8_t>& bytes_;
};

}  // namespace echomap::ros_messages
