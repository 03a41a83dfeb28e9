// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "host/ros_messages/std_msgs.hpp"

namespace echomap::ros_messages {

/// One value of a diagnosis, by its name.
struct KeyValue {
  static constexpr std::string_view kName = "diagnostic_msgs/msg/KeyValue";
  std::string key;
  std::string value;
  bool operator==(const KeyValue&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("key", self.key);
    visit("value", self.value);
  }
};

/// How one part of a robot is.
struct DiagnosticStatus {
  static constexpr std::string_view kName = "diagnostic_msgs/msg/DiagnosticStatus";
  static constexpr std::byte kOk{0};
  static constexpr std::byte kWarn{1};
  static constexpr std::byte kError{2};
  static constexpr std::byte kStale{3};
  std::byte level = kOk;
  std::string name;
  std::string message;
  std::string hardware_id;
  std::vector<KeyValue> values;
  bool operator==(const DiagnosticStatus&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("level", self.level);
    visit("name", self.name);
    visit("message", self.message);
    visit("hardware_id", self.hardware_id);
    visit("values", self.values);
  }
};

/// How the parts of a robot are at one instant.
struct DiagnosticArray {
  static constexpr std::string_view kName = "diagnostic_msgs/msg/DiagnosticArray";
  Header header;
  std::vector<DiagnosticStatus> status;
  bool operator==(const DiagnosticArray&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("status", self.status);
  }
};

}  // namespace echomap::ros_messages
