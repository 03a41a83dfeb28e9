// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace echomap::mcap {

/// Where the messages of one channel are in the chunk before it.
struct MessageIndex {
  std::uint16_t channel_id = 0;
  /// Log time in nanoseconds and place of the record in the uncompressed chunk.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> entries;
};

/// Takes the content of a message index apart. Throws RecordError where the entries do not fill it
/// exactly.
MessageIndex decode_message_index(std::span<const std::uint8_t> content);

/// True where the index has entries and each points at a message of its channel and log time in
/// `chunk`, which is uncompressed.
bool points_into(const MessageIndex& index, std::span<const std::uint8_t> chunk);

/// The same for the content of a record that may be something else than an index.
bool is_index_into(std::span<const std::uint8_t> content, std::span<const std::uint8_t> chunk);

}  // namespace echomap::mcap
