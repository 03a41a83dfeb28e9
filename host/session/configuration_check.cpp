// SPDX-License-Identifier: MIT
#include "host/session/configuration_check.hpp"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

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

}  // namespace

std::optional<protocol::Configuration> configuration_in(const robot_link::BulkResult& result) {
  protocol::ConfigurationBytes bytes{};
  protocol::Configuration configuration{};
  if (result.status != robot_link::BulkStatus::kWhole ||
      result.bytes.size() != protocol::ConfigurationBytes::kSize) {
    return std::nullopt;
  }
  std::memcpy(bytes.bytes, result.bytes.data(), result.bytes.size());
  return protocol::read_configuration(bytes, configuration) ? std::optional(configuration)
                                                            : std::nullopt;
}

std::vector<robot_link::Command> commands_between(
    const std::optional<protocol::Configuration>& held, const protocol::Configuration& wanted) {
  const std::vector<Part> wanted_parts = parts_of(wanted);
  const std::vector<Part> held_parts = held ? parts_of(*held) : std::vector<Part>();
  std::vector<robot_link::Command> commands;
  for (std::size_t i = 0; i < wanted_parts.size(); ++i) {
    if (!held || !is_same(held_parts[i].fields, wanted_parts[i].fields)) {
      commands.push_back(wanted_parts[i].command);
    }
  }
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
