// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace echomap::ros_messages {

/// An instant on the clock that the publisher uses: since 1970 on a real robot.
struct Time {
  static constexpr std::string_view kName = "builtin_interfaces/msg/Time";
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;  ///< To be added to `sec`, also to a negative one.
  bool operator==(const Time&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("sec", self.sec);
    visit("nanosec", self.nanosec);
  }
};

/// A span of time.
struct Duration {
  static constexpr std::string_view kName = "builtin_interfaces/msg/Duration";
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;  ///< To be added to `sec`, also to a negative one.
  bool operator==(const Duration&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("sec", self.sec);
    visit("nanosec", self.nanosec);
  }
};

}  // namespace echomap::ros_messages
