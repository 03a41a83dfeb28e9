// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

#include "host/ros_messages/field_types.hpp"

namespace echomap::tests {

/// A visitor that fills the fields of a ROS message with anything; sequences have up to four
/// elements. Numbers are numbers, so that messages can be compared.
class RandomFields {
 public:
  explicit RandomFields(std::mt19937& random) : random_(random) {}

  template <class T>
  void operator()(std::string_view /*name*/, T& value) {
    fill(value);
  }

 private:
  template <class T>
  void fill(T& value) {
    if constexpr (ros_messages::Message<T>) {
      T::fields(value, *this);
    } else if constexpr (ros_messages::Sequence<T>) {
      value.resize(random_() % 5);
      fill_elements(value);
    } else if constexpr (ros_messages::FixedArray<T>) {
      fill_elements(value);
    } else if constexpr (std::same_as<T, std::string>) {
      value = std::string(random_() % 8, static_cast<char>('a' + random_() % 26));
    } else if constexpr (std::floating_point<T>) {
      value = static_cast<T>(random_()) / static_cast<T>(1024) - static_cast<T>(1e6);
    } else if constexpr (std::same_as<T, bool>) {
      value = random_() % 2 == 0;
    } else {
      value = static_cast<T>(random_());
    }
  }
  template <class T>
  void fill_elements(T& values) {
    for (auto& value : values) {
      fill(value);
    }
  }

  std::mt19937& random_;
};

/// A message with random content.
template <ros_messages::Message M>
M random_message(std::mt19937& random) {
  M message;
  RandomFields fill(random);
  M::fields(message, fill);
  return message;
}

}  // namespace echomap::tests
