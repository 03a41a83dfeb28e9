// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/fleet_messages/payload.hpp"

namespace echomap::tests {

/// A visitor that fills the fields of a fleet's message with anything that it may hold; tables and
/// lists have up to four elements.
class RandomFleetFields {
 public:
  explicit RandomFleetFields(std::mt19937& random) : random_(random) {}

  template <std::integral T>
  void operator()(std::string_view /*name*/,
                  T& value,
                  std::uint64_t max = fleet_messages::kAnyValue<T>) {
    const std::uint64_t any = (std::uint64_t{random_()} << 32U) + random_();
    // Small numbers are as likely as large ones.
    const std::uint64_t some = any >> random_() % 64;
    value = static_cast<T>(max == fleet_messages::kAnyValue<T> ? some : some % (max + 1));
  }
  void operator()(std::string_view /*name*/, std::string& text) {
    text = std::string(1 + random_() % 32, static_cast<char>('a' + random_() % 26));
  }
  void operator()(std::string_view /*name*/, fleet_messages::ContentHash& hash) {
    for (std::uint8_t& byte : hash.bytes) {
      byte = static_cast<std::uint8_t>(random_());
    }
  }
  template <fleet_messages::MessagePart Part>
  void operator()(std::string_view /*name*/, Part& part) {
    Part::fields(part, *this);
  }
  template <class T>
  void operator()(std::string_view name, std::vector<T>& elements) {
    elements.resize(1 + random_() % 4);
    for (T& element : elements) {
      if constexpr (fleet_messages::TableRow<T>) {
        T::fields(element, *this);
      } else {
        (*this)(name, element);
      }
    }
  }

 private:
  std::mt19937& random_;
};

/// A message of the type with that index in MessageBody.
template <std::size_t kIndex = 0>
fleet_messages::MessageBody random_fleet_body(std::mt19937& random, std::size_t index) {
  if constexpr (kIndex < std::variant_size_v<fleet_messages::MessageBody>) {
    if (index != kIndex) {
      return random_fleet_body<kIndex + 1>(random, index);
    }
    std::variant_alternative_t<kIndex, fleet_messages::MessageBody> message;
    RandomFleetFields fill(random);
    decltype(message)::fields(message, fill);
    if constexpr (requires { message.end_ms; }) {
      message.end_ms = std::max(message.begin_ms, message.end_ms);
    }
    if constexpr (requires { message.waits_for; }) {
      message.waits_for.resize(random() % 2);
    }
    return message;
  } else {
    return {};
  }
}

/// A message of that type by anybody.
inline fleet_messages::FleetMessage random_fleet_message(std::mt19937& random, std::size_t index) {
  fleet_messages::FleetMessage message{{}, random_fleet_body(random, index)};
  RandomFleetFields fill(random);
  fill("robot", message.sender.robot);
  if (!fleet_messages::is_object(fleet_messages::kind_of(message.body))) {
    fill("boot_id", message.sender.boot_id);
    fill("counter", message.sender.counter);
  }
  return message;
}

}  // namespace echomap::tests
