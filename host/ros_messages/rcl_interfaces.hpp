// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host/ros_messages/builtin_interfaces.hpp"

namespace echomap::ros_messages {

/// One line of a program's log, as on `/rosout`.
struct Log {
  static constexpr std::string_view kName = "rcl_interfaces/msg/Log";
  static constexpr std::uint8_t kDebug = 10;
  static constexpr std::uint8_t kInfo = 20;
  static constexpr std::uint8_t kWarn = 30;
  static constexpr std::uint8_t kError = 40;
  static constexpr std::uint8_t kFatal = 50;
  Time stamp;
  std::uint8_t level = kInfo;
  std::string name;
  std::string msg;
  std::string file;
  std::string function;
  std::uint32_t line = 0;
  bool operator==(const Log&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("stamp", self.stamp);
    visit("level", self.level);
    visit("name", self.name);
    visit("msg", self.msg);
    visit("file", self.file);
    visit("function", self.function);
    visit("line", self.line);
  }
};

}  // namespace echomap::ros_messages
