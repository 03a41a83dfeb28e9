// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace echomap::ros_messages {

/// A ROS 2 message: a struct with its type's name, `package/msg/Name`, and a static template
/// `fields(self, visit)` that calls `visit("name", self.name)` for each field in the order of the
/// type's definition. Serialization, deserialization and the text of the definition follow from
/// that list.
template <class T>
concept Message = requires {
  { T::kName } -> std::convertible_to<std::string_view>;
};

/// A field that is one number, truth value or byte.
template <class T>
concept Primitive = std::is_arithmetic_v<T> || std::same_as<T, std::byte>;

/// True for a vector.
template <class T>
inline constexpr bool kIsSequence = false;
template <class T>
inline constexpr bool kIsSequence<std::vector<T>> = true;

/// True for an array.
template <class T>
inline constexpr bool kIsFixedArray = false;
template <class T, std::size_t kCount>
inline constexpr bool kIsFixedArray<std::array<T, kCount>> = true;

/// A field of any number of elements.
template <class T>
concept Sequence = kIsSequence<T>;

/// A field of a number of elements that the type fixes.
template <class T>
concept FixedArray = kIsFixedArray<T>;

/// What a sequence or an array has elements of; of any other field its own type.
template <class T>
struct ElementOf {
  using Type = T;
};
template <class T>
  requires Sequence<T> || FixedArray<T>
struct ElementOf<T> {
  using Type = typename T::value_type;
};

/// The name of a number's type in a message definition.
template <Primitive T>
constexpr std::string_view primitive_name() {
  if constexpr (std::same_as<T, bool>) {
    return "bool";
  } else if constexpr (std::same_as<T, std::byte>) {
    return "byte";
  } else if constexpr (std::same_as<T, char>) {
    return "char";
  } else if constexpr (std::floating_point<T>) {
    return sizeof(T) == 4 ? "float32" : "float64";
  } else {
    constexpr std::array<std::string_view, 4> kSigned{"int8", "int16", "int32", "int64"};
    constexpr std::array<std::string_view, 4> kUnsigned{"uint8", "uint16", "uint32", "uint64"};
    constexpr std::size_t kIndex = sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 1 : sizeof(T) == 4 ? 2 : 3;
    return std::is_signed_v<T> ? kSigned[kIndex] : kUnsigned[kIndex];
  }
}

}  // namespace echomap::ros_messages
