// SPDX-License-Identifier: MIT
#include "host/mcap/channel_table.hpp"

#include <string>
#include <utility>

#include "host/mcap/record_decoding.hpp"
#include "host/mcap/record_reader.hpp"

namespace echomap::mcap {

std::optional<Message> ChannelTable::take(Opcode opcode, std::span<const std::uint8_t> content) {
  switch (opcode) {
    case Opcode::kSchema:
      take_schema(content);
      return std::nullopt;
    case Opcode::kChannel:
      take_channel(content);
      return std::nullopt;
    case Opcode::kMessage:
      return message_of(content);
    default:
      return std::nullopt;
  }
}

void ChannelTable::take_schema(std::span<const std::uint8_t> content) {
  auto [id, schema] = decode_schema(content);
  if (id == 0) {
    return;  // Channels say 0 where they have none; the specification has readers ignore it.
  }
  const auto known = schemas_.find(id);
  if (known == schemas_.end()) {
    schemas_.emplace(id, std::make_shared<const Schema>(std::move(schema)));
  } else if (*known->second != schema) {
    throw RecordError("schema " + std::to_string(id) + " is defined in two ways");
  }
}

void ChannelTable::take_channel(std::span<const std::uint8_t> content) {
  auto [id, info] = decode_channel(content);
  const auto known = channels_.find(id);
  if (known != channels_.end()) {
    if (known->second->info != info) {
      throw RecordError("channel " + std::to_string(id) + " is defined in two ways");
    }
    return;
  }
  std::shared_ptr<const Schema> schema;
  if (info.schema_id != 0) {
    const auto found = schemas_.find(info.schema_id);
    if (found == schemas_.end()) {
      throw RecordError("channel " + std::to_string(id) + " has the unknown schema " +
                        std::to_string(info.schema_id));
    }
    schema = found->second;
  }
  channels_.emplace(
      id, std::make_shared<const Channel>(Channel{id, std::move(info), std::move(schema)}));
}

Message ChannelTable::message_of(std::span<const std::uint8_t> content) const {
  const MessageFields fields = decode_message(content);
  const auto channel = channels_.find(fields.channel_id);
  if (channel == channels_.end()) {
    throw RecordError("a message of the unknown channel " + std::to_string(fields.channel_id));
  }
  return {channel->second,
          fields.sequence,
          fields.log_time_ns,
          fields.publish_time_ns,
          {fields.data.begin(), fields.data.end()}};
}

}  // namespace echomap::mcap
