// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
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

/// A pose at most so far from another one, by the pose.
inline fleet_messages::PoseRow brought_near(fleet_messages::PoseRow pose,
                                            const fleet_messages::PoseRow& middle,
                                            std::int64_t reach_mm) {
  const auto near_mm = [&](std::int32_t at_mm, std::int32_t middle_mm) {
    const std::int64_t moved_mm = middle_mm + at_mm % reach_mm;
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(moved_mm, INT32_MIN, INT32_MAX));
  };
  pose.x_mm = near_mm(pose.x_mm, middle.x_mm);
  pose.y_mm = near_mm(pose.y_mm, middle.y_mm);
  return pose;
}

/// What random numbers hardly ever are.
inline void make_consistent(fleet_messages::PresenceMessage& message) {
  message.body_radius_mm %= 5001;
  message.beam_half_angle = static_cast<std::uint16_t>(1 + message.beam_half_angle % 8192);
}
inline void make_consistent(fleet_messages::AlignmentMessage& message) {
  for (fleet_messages::AlignedMapPart& map : message.maps) {
    map.T_component_map = brought_near(map.T_component_map, {}, fleet_messages::kMaxTeamReachMm);
    for (fleet_messages::PoseRow& pose : map.T_component_submaps) {
      pose = brought_near(pose, {}, fleet_messages::kMaxTeamReachMm);
    }
  }
}
inline void make_consistent(fleet_messages::GraphMessage& message) {
  for (fleet_messages::PoseRow& pose : message.T_map_submaps) {
    pose = brought_near(pose, {}, fleet_messages::kMaxMapReachMm);
  }
}
inline void make_consistent(fleet_messages::SubmapMessage& message) {
  message.end_ms = std::max(message.begin_ms, message.end_ms);
  const fleet_messages::PoseRow first = message.readings.front().T_odom_robot;
  const auto bring_near = [&](fleet_messages::PoseRow& pose) {
    pose = brought_near(pose, first, fleet_messages::kMaxSubmapReachMm);
  };
  std::ranges::for_each(message.readings, bring_near, &fleet_messages::ReadingRow::T_odom_robot);
  message.readings.front().T_odom_robot = first;
  std::ranges::for_each(message.T_odom_way, bring_near);
  std::ranges::for_each(message.contacts, bring_near, &fleet_messages::ContactRow::T_odom_robot);
}
inline void make_consistent(fleet_messages::ClaimMessage& message) {
  message.waits_for.resize(message.waits_for.size() % 2);
}

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
    if constexpr (requires { make_consistent(message); }) {
      make_consistent(message);
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
