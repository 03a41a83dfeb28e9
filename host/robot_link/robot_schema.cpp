// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_schema.hpp"

#include <algorithm>

#include "protocol/messages.hpp"
#include "protocol/schema_reader.hpp"

namespace echomap::robot_link {
namespace {

std::uint8_t bytes_of(char type_code) {
  switch (type_code) {
    case 'B':
    case 'b':
      return 1;
    case 'H':
    case 'h':
      return 2;
    default:
      return 4;
  }
}

/// Seed and length of the message under way, as MessageFacts computes them.
struct Sum {
  protocol::SchemaHash hash;
  unsigned bytes = 0;
};

void finish(std::vector<DescribedMessage>& messages, const Sum& sum) {
  if (!messages.empty()) {
    messages.back().schema = {sum.hash.folded(), static_cast<std::uint8_t>(sum.bytes)};
  }
}

/// Compares one message of ours after the other; a handler of MessageList::for_each.
struct CompareWith {
  const std::vector<DescribedMessage>& robot;
  std::vector<std::uint8_t>& agreed;
  std::vector<std::string>& different;
  std::vector<std::string>& missing;

  template <class M>
  void operator()(const M* /*of*/) {
    const auto theirs = std::ranges::find(robot, M::kId, &DescribedMessage::id);
    if (theirs == robot.end()) {
      missing.emplace_back(M::name());
    } else if (theirs->schema.seed == protocol::MessageFacts<M>::kSeed) {
      agreed.push_back(M::kId);
    } else {
      different.emplace_back(M::name());
    }
  }
};

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace

std::optional<std::vector<DescribedMessage>> read_robot_schema(
    std::span<const std::uint8_t> description) {
  protocol::SchemaReader reader(description.data(), static_cast<std::uint16_t>(description.size()));
  std::vector<DescribedMessage> messages;
  Sum sum;
  while (true) {
    switch (reader.next()) {
      case protocol::SchemaItem::kMessage:
        finish(messages, sum);
        sum = {};
        messages.push_back({reader.id(), reader.name(), {}});
        sum.hash.add_text(reader.name());
        break;
      case protocol::SchemaItem::kField:
        sum.hash.add_text(reader.name());
        sum.hash.add(reader.type_code());
        sum.bytes += bytes_of(reader.type_code());
        break;
      case protocol::SchemaItem::kEnd:
        finish(messages, sum);
        return messages;
      case protocol::SchemaItem::kMalformed:
        return std::nullopt;
    }
  }
}

std::uint32_t digest_of(const std::vector<DescribedMessage>& messages) {
  protocol::SchemaHash hash;
  for (const DescribedMessage& message : messages) {
    hash.add(static_cast<char>(message.id));
    hash.add(static_cast<char>(message.schema.seed & 0xFF));
    hash.add(static_cast<char>(message.schema.seed >> 8));
  }
  return hash.value();
}

SchemaDifference::SchemaDifference(const std::vector<DescribedMessage>& robot) {
  CompareWith compare{robot, agreed_, different_, missing_on_robot_};
  protocol::AllMessages::for_each(compare);
  for (const DescribedMessage& message : robot) {
    if (agrees(message.id)) {
      continue;
    }
    foreign_.push_back(message);
    if (!protocol::AllMessages::find_schema(message.id).known()) {
      unknown_to_host_.push_back(message.name);
    }
  }
}

bool SchemaDifference::agrees(std::uint8_t id) const {
  return std::ranges::find(agreed_, id) != agreed_.end();
}

std::optional<protocol::Schema> SchemaDifference::foreign(std::uint8_t id) const {
  const auto found = std::ranges::find(foreign_, id, &DescribedMessage::id);
  return found == foreign_.end() ? std::nullopt : std::optional(found->schema);
}

std::string SchemaDifference::summary() const {
  std::string text;
  const auto add = [&text](const std::string& intro, const std::vector<std::string>& names) {
    if (!names.empty()) {
      text += (text.empty() ? "" : "; ") + intro + joined(names);
    }
  };
  add("other fields in ", different_);
  add("the robot lacks ", missing_on_robot_);
  add("this host lacks ", unknown_to_host_);
  return text;
}

}  // namespace echomap::robot_link
