// SPDX-License-Identifier: MIT
#include "host/fleet_messages/topic.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <vector>

#include "host/mqtt/fleet_name.hpp"

namespace echomap::fleet_messages {
namespace {

constexpr std::string_view kRoot = "echomap/1/";

/// What a kind's topics end with.
enum class IdType : std::uint8_t { kNone, kNumber, kHash };

struct TopicRow {
  std::string_view name;
  IdType id;
  bool is_retained;
};

constexpr std::array<TopicRow, std::size(kTopicKinds)> kTopicRows{{
    {"presence", IdType::kNone, true},
    {"pose", IdType::kNone, false},
    {"submap", IdType::kHash, true},
    {"graph", IdType::kNumber, true},
    {"manifest", IdType::kNumber, true},
    {"claim", IdType::kNone, true},
    {"source", IdType::kHash, true},
    {"clock", IdType::kNone, true},
    {"alignment", IdType::kNone, true},
    {"ask", IdType::kNone, false},
    {"search", IdType::kNone, true},
    {"relay", IdType::kHash, true},
}};

const TopicRow& row_of(TopicKind kind) { return kTopicRows[static_cast<std::size_t>(kind)]; }

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t slash = text.find('/'); slash != std::string_view::npos;
       slash = text.find('/')) {
    parts.push_back(text.substr(0, slash));
    text.remove_prefix(slash + 1);
  }
  parts.push_back(text);
  return parts;
}

/// Decimal digits without a sign and without leading zeros.
std::optional<std::uint16_t> parse_topic_number(std::string_view text) {
  std::uint16_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole && std::to_string(number) == text ? std::optional(number) : std::nullopt;
}

std::optional<TopicId> parse_id(IdType type, std::string_view text) {
  if (type == IdType::kNumber) {
    const auto number = parse_topic_number(text);
    return number ? std::optional<TopicId>(*number) : std::nullopt;
  }
  const auto hash = parse_hash(text);
  return hash ? std::optional<TopicId>(*hash) : std::nullopt;
}

}  // namespace

std::string_view name_of(TopicKind kind) { return row_of(kind).name; }

bool is_retained(TopicKind kind) { return row_of(kind).is_retained; }

std::string format_topic(const FleetTopic& topic) {
  std::string text(kRoot);
  text.append(topic.fleet).append("/").append(topic.robot).append("/").append(name_of(topic.kind));
  if (const auto* number = std::get_if<std::uint16_t>(&topic.id)) {
    text += "/" + std::to_string(*number);
  } else if (const auto* hash = std::get_if<ContentHash>(&topic.id)) {
    text += "/" + hex(*hash);
  }
  return text;
}

std::optional<FleetTopic> parse_topic(std::string_view text) {
  if (text.substr(0, kRoot.size()) != kRoot) {
    return std::nullopt;
  }
  const std::vector<std::string_view> parts = split(text.substr(kRoot.size()));
  if (parts.size() < 3 || !mqtt::is_fleet_name(parts[0]) || !mqtt::is_fleet_name(parts[1])) {
    return std::nullopt;
  }
  const auto row = std::find_if(kTopicRows.begin(), kTopicRows.end(), [&](const TopicRow& known) {
    return known.name == parts[2];
  });
  if (row == kTopicRows.end() || parts.size() != (row->id == IdType::kNone ? 3 : 4)) {
    return std::nullopt;
  }
  FleetTopic topic{std::string(parts[0]),
                   std::string(parts[1]),
                   kTopicKinds[row - kTopicRows.begin()],
                   std::monostate{}};
  if (row->id == IdType::kNone) {
    return topic;
  }
  const auto id = parse_id(row->id, parts[3]);
  if (!id) {
    return std::nullopt;
  }
  topic.id = *id;
  return topic;
}

std::string fleet_filter(std::string_view fleet) {
  return std::string(kRoot) + std::string(fleet) + "/#";
}

}  // namespace echomap::fleet_messages
