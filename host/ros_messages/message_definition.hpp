// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "host/ros_messages/field_types.hpp"

namespace echomap::ros_messages {

/// Collects the definitions of a message and of every message nested in it, each once, and joins
/// them to one text.
class MessageDefinitions {
 public:
  /// Adds M and what is nested in it, unless it is there.
  template <Message M>
  void add() {
    if (!begin(M::kName)) {
      return;
    }
    const M message{};
    const auto write_field = [this]<class Field>(std::string_view name, const Field& /*value*/) {
      write_line(type_of<Field>(), name);
    };
    M::fields(message, write_field);
    const auto add_nested = [&]<class Field>(std::string_view /*name*/, const Field& /*value*/) {
      if constexpr (Message<typename ElementOf<Field>::Type>) {
        this->add<typename ElementOf<Field>::Type>();
      }
    };
    M::fields(message, add_nested);
  }

  /// The first message's fields, then for each other one a line of 80 equals signs, its name after
  /// `MSG: `, and its fields.
  std::string text() const;

 private:
  struct Definition {
    std::string_view name;
    std::string fields;
  };

  /// `package/Name`, as definitions write the type `package/msg/Name`.
  static std::string short_name(std::string_view name);

  template <class Field>
  static std::string type_of() {
    using Element = typename ElementOf<Field>::Type;
    std::string type;
    if constexpr (Message<Element>) {
      type = short_name(Element::kName);
    } else if constexpr (Primitive<Element>) {
      type = primitive_name<Element>();
    } else {
      type = "string";
    }
    if constexpr (Sequence<Field>) {
      type += "[]";
    } else if constexpr (FixedArray<Field>) {
      type += "[" + std::to_string(std::tuple_size_v<Field>) + "]";
    }
    return type;
  }

  /// False where the message is there already.
  bool begin(std::string_view name);
  /// Adds a field to the message that was begun last.
  void write_line(const std::string& type, std::string_view name);

  std::vector<Definition> definitions_;
};

/// The definition of M and of every type nested in it, as the schema encoding `ros2msg` of MCAP
/// wants it.
template <Message M>
std::string message_definition() {
  MessageDefinitions definitions;
  definitions.add<M>();
  return definitions.text();
}

}  // namespace echomap::ros_messages
