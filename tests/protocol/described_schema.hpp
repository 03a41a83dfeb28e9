// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "protocol/messages.hpp"
#include "protocol/schema_description.hpp"
#include "protocol/schema_reader.hpp"
#include "tests/protocol/frames.hpp"

namespace echomap::protocol {

/// What the robot says of its schema.
inline constexpr auto kDescription = describe_schema<AllMessages>();
inline const Bytes description(std::begin(kDescription.bytes), std::end(kDescription.bytes));

/// A message as a description tells it.
struct DescribedMessage {
  int id = 0;
  std::string name;
  std::vector<std::pair<std::string, char>> fields;  ///< Names and type codes.

  bool operator==(const DescribedMessage& other) const {
    return id == other.id && name == other.name && fields == other.fields;
  }
};

/// What a description says; empty for a malformed one.
inline std::optional<std::vector<DescribedMessage>> read_description(const Bytes& bytes) {
  SchemaReader reader(bytes.data(), static_cast<std::uint16_t>(bytes.size()));
  std::vector<DescribedMessage> messages;
  for (;;) {
    switch (reader.next()) {
      case SchemaItem::kMessage:
        messages.push_back({reader.id(), reader.name(), {}});
        break;
      case SchemaItem::kField:
        messages.back().fields.emplace_back(reader.name(), reader.type_code());
        break;
      case SchemaItem::kEnd:
        return messages;
      case SchemaItem::kMalformed:
        return std::nullopt;
    }
  }
}

}  // namespace echomap::protocol
