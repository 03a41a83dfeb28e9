// SPDX-License-Identifier: MIT
#include "host/ros_messages/message_definition.hpp"

#include <algorithm>

namespace echomap::ros_messages {

std::string MessageDefinitions::text() const {
  std::string text;
  for (const Definition& definition : definitions_) {
    if (!text.empty()) {
      text += std::string(80, '=') + "\nMSG: " + short_name(definition.name) + "\n";
    }
    text += definition.fields;
  }
  return text;
}

std::string MessageDefinitions::short_name(std::string_view name) {
  std::string short_name(name);
  constexpr std::string_view kMiddle = "/msg/";
  return short_name.replace(short_name.find(kMiddle), kMiddle.size(), "/");
}

bool MessageDefinitions::begin(std::string_view name) {
  if (std::any_of(definitions_.begin(), definitions_.end(), [name](const Definition& known) {
        return known.name == name;
      })) {
    return false;
  }
  definitions_.push_back({name, ""});
  return true;
}

void MessageDefinitions::write_line(const std::string& type, std::string_view name) {
  definitions_.back().fields += type + " ";
  definitions_.back().fields += name;
  definitions_.back().fields += "\n";
}

}  // namespace echomap::ros_messages
