// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "host/ros_messages/builtin_interfaces.hpp"

namespace echomap::ros_messages {

/// When a measurement was taken, and the frame of its coordinates.
struct Header {
  static constexpr std::string_view kName = "std_msgs/msg/Header";
  Time stamp;
  std::string frame_id;
  bool operator==(const Header&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("stamp", self.stamp);
    visit("frame_id", self.frame_id);
  }
};

/// A colour whose parts and opacity are 0 .. 1.
struct ColorRGBA {
  static constexpr std::string_view kName = "std_msgs/msg/ColorRGBA";
  float r = 0.0F;
  float g = 0.0F;
  float b = 0.0F;
  float a = 0.0F;
  bool operator==(const ColorRGBA&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("r", self.r);
    visit("g", self.g);
    visit("b", self.b);
    visit("a", self.a);
  }
};

/// A text alone.
struct String {
  static constexpr std::string_view kName = "std_msgs/msg/String";
  std::string data;
  bool operator==(const String&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("data", self.data);
  }
};

}  // namespace echomap::ros_messages
