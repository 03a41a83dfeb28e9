// SPDX-License-Identifier: MIT
#include "host/mcap/message_index.hpp"

#include <algorithm>

#include "host/mcap/file_layout.hpp"
#include "host/mcap/record_decoding.hpp"
#include "host/mcap/record_reader.hpp"

namespace echomap::mcap {

namespace {

constexpr std::size_t kEntryBytes = 2 * sizeof(std::uint64_t);

bool has_message_at(std::span<const std::uint8_t> chunk,
                    std::uint16_t channel_id,
                    const std::pair<std::uint64_t, std::uint64_t>& entry) {
  if (entry.second >= chunk.size()) {
    return false;
  }
  try {
    RecordReader reader(chunk.subspan(static_cast<std::size_t>(entry.second)));
    const auto opcode = static_cast<Opcode>(reader.number<std::uint8_t>());
    const MessageFields message = decode_message(reader.bytes(reader.number<std::uint64_t>()));
    return opcode == Opcode::kMessage && message.channel_id == channel_id &&
           message.log_time_ns == entry.first;
  } catch (const RecordError&) {
    return false;
  }
}

}  // namespace

MessageIndex decode_message_index(std::span<const std::uint8_t> content) {
  RecordReader reader(content);
  MessageIndex index;
  index.channel_id = reader.number<std::uint16_t>();
  const auto entry_bytes = reader.number<std::uint32_t>();
  if (entry_bytes != reader.rest().size() || entry_bytes % kEntryBytes != 0) {
    throw RecordError("the entries of a message index do not fill it");
  }
  index.entries.reserve(entry_bytes / kEntryBytes);
  while (!reader.rest().empty()) {
    const auto log_time_ns = reader.number<std::uint64_t>();
    index.entries.emplace_back(log_time_ns, reader.number<std::uint64_t>());
  }
  return index;
}

bool points_into(const MessageIndex& index, std::span<const std::uint8_t> chunk) {
  return !index.entries.empty() &&
         std::all_of(index.entries.begin(), index.entries.end(), [&](const auto& entry) {
           return has_message_at(chunk, index.channel_id, entry);
         });
}

bool is_index_into(std::span<const std::uint8_t> content, std::span<const std::uint8_t> chunk) {
  try {
    return points_into(decode_message_index(content), chunk);
  } catch (const RecordError&) {
    return false;
  }
}

}  // namespace echomap::mcap
