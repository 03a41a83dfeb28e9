// SPDX-License-Identifier: MIT
#include "host/session/configuration_check.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <span>
#include <variant>

#include <fmt/format.h>

#include "protocol/message_schema.hpp"

namespace echomap::session {
namespace {

struct Field {
  std::string name;
  std::int64_t value;
};

/// Fields of one message; a visitor of them. The command_id does not belong to a configuration.
struct TakeFields {
  const char* message;
  std::vector<Field>& fields;
  template <class T>
  void operator()(std::string_view name, const T& value) {
    if (name != "command_id") {
      fields.push_back({fmt::format("{}.{}", message, name), static_cast<std::int64_t>(value)});
    }
  }
};

/// One command of a configuration with its fields.
struct Part {
  robot_link::Command command;
  std::vector<Field> fields;
};

struct TakeParts {
  std::vector<Part>& parts;
  template <class M>
  void operator()(const M& message) {
    parts.push_back({message, {}});
    TakeFields fields{M::name(), parts.back().fields};
    M::each(message, fields);
  }
};

std::vector<Part> parts_of(const protocol::Configuration& configuration) {
  std::vector<Part> parts;
  TakeParts take{parts};
  protocol::Configuration::each(configuration, take);
  return parts;
}

bool is_same(const std::vector<Field>& one, const std::vector<Field>& other) {
  return std::ranges::equal(one, other, {}, &Field::value, &Field::value);
}

constexpr std::size_t kWiringBytes = protocol::payload_size_of<protocol::ConfigureWiring>();
constexpr std::size_t kScalarBytes = protocol::payload_size_of<protocol::ConfigureScalar>();

/// Bytes of a configuration; wiring and scalar are the last of its messages.
constexpr std::size_t bytes_of(ConfigurationExtent extent) {
  return protocol::ConfigurationBytes::kSize -
         (extent == ConfigurationExtent::kWhole ? 0 : kScalarBytes) -
         (extent == ConfigurationExtent::kWithoutWiring ? kWiringBytes : 0);
}

template <class M>
void erase_command(std::vector<robot_link::Command>& commands) {
  std::erase_if(commands, [](const robot_link::Command& command) {
    return std::holds_alternative<M>(command);
  });
}

template <class M>
auto find_command(std::vector<robot_link::Command>& commands) {
  return std::ranges::find_if(commands, [](const robot_link::Command& command) {
    return std::holds_alternative<M>(command);
  });
}

/// A pin must be without a function before a bridge may have it, and out of the bridge's hands
/// before it may have another: all pins are freed, then bridges connected, then pins used.
void order_wiring_and_pins(std::vector<robot_link::Command>& commands) {
  const auto wiring = find_command<protocol::ConfigureWiring>(commands);
  const auto pins = find_command<protocol::ConfigurePins>(commands);
  if (wiring == commands.end() || pins == commands.end()) {
    return;
  }
  std::rotate(pins, wiring, std::next(wiring));
  commands.insert(find_command<protocol::ConfigureWiring>(commands), protocol::ConfigurePins{});
}

}  // namespace

ConfigurationExtent extent_of(const std::optional<robot_link::SchemaDifference>& difference) {
  if (!difference || difference->agrees(protocol::ConfigureScalar::kId)) {
    return ConfigurationExtent::kWhole;
  }
  return difference->agrees(protocol::ConfigureWiring::kId) ? ConfigurationExtent::kWithoutScalar
                                                            : ConfigurationExtent::kWithoutWiring;
}

bool is_usual(const protocol::ConfigureWiring& wiring) {
  return wiring.bridge == 0 && wiring.bridge_options == 0 && wiring.contacts_normally_closed == 0;
}

std::uint32_t digest_of(const protocol::Configuration& configuration, ConfigurationExtent extent) {
  const protocol::ConfigurationBytes bytes = protocol::configuration_bytes(configuration);
  protocol::SchemaHash hash;
  for (const std::uint8_t byte : std::span(bytes.bytes).first(bytes_of(extent))) {
    hash.add(static_cast<char>(byte));
  }
  return hash.value();
}

std::optional<protocol::Configuration> configuration_in(const robot_link::BulkResult& result,
                                                        ConfigurationExtent extent) {
  // What the robot does not hold stays as in an empty configuration: the usual wiring, no scalar.
  protocol::Configuration configuration{};
  protocol::ConfigurationBytes bytes = protocol::configuration_bytes(configuration);
  if (result.status != robot_link::BulkStatus::kWhole || result.bytes.size() != bytes_of(extent)) {
    return std::nullopt;
  }
  std::memcpy(bytes.bytes, result.bytes.data(), result.bytes.size());
  return protocol::read_configuration(bytes, configuration) ? std::optional(configuration)
                                                            : std::nullopt;
}

std::vector<robot_link::Command> commands_between(
    const std::optional<protocol::Configuration>& held,
    const protocol::Configuration& wanted,
    ConfigurationExtent extent) {
  const std::vector<Part> wanted_parts = parts_of(wanted);
  const std::vector<Part> held_parts = held ? parts_of(*held) : std::vector<Part>();
  std::vector<robot_link::Command> commands;
  for (std::size_t i = 0; i < wanted_parts.size(); ++i) {
    if (!held || !is_same(held_parts[i].fields, wanted_parts[i].fields)) {
      commands.push_back(wanted_parts[i].command);
    }
  }
  if (extent != ConfigurationExtent::kWhole) {
    erase_command<protocol::ConfigureScalar>(commands);
  }
  if (extent == ConfigurationExtent::kWithoutWiring) {
    erase_command<protocol::ConfigureWiring>(commands);
  }
  order_wiring_and_pins(commands);
  return commands;
}

std::string first_difference(const protocol::Configuration& held,
                             const protocol::Configuration& wanted) {
  const std::vector<Part> held_parts = parts_of(held);
  const std::vector<Part> wanted_parts = parts_of(wanted);
  for (std::size_t i = 0; i < wanted_parts.size(); ++i) {
    for (std::size_t j = 0; j < wanted_parts[i].fields.size(); ++j) {
      const Field& is = held_parts[i].fields[j];
      const Field& shall = wanted_parts[i].fields[j];
      if (is.value != shall.value) {
        return fmt::format("{} is {}, not {}", shall.name, is.value, shall.value);
      }
    }
  }
  return "";
}

std::string name_of(const robot_link::Command& command) {
  return std::visit([](const auto& message) { return std::string(message.name()); }, command);
}

}  // namespace echomap::session
