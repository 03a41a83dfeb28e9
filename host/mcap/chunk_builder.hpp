// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "host/mcap/chunk_compression.hpp"
#include "host/mcap/message_index.hpp"
#include "host/mcap/record_encoding.hpp"
#include "host/mcap/records.hpp"
#include "host/mcap/summary.hpp"

namespace echomap::mcap {

/// Collects the records of one chunk, uncompressed, and where its messages are.
class ChunkBuilder {
 public:
  void add_schema(std::uint16_t id, const Schema& schema) { append_schema(records_, id, schema); }
  void add_channel(std::uint16_t id, const ChannelInfo& info) {
    append_channel(records_, id, info);
  }
  void add_message(const MessageFields& message);

  bool has_messages() const { return !indexes_.empty(); }
  /// Schemas, channels and messages so far, as they are before compression.
  const Bytes& records() const { return records_; }
  /// Log time of the message that was added first; 0 before it.
  std::uint64_t first_log_time_ns() const { return first_log_time_ns_; }

  /// Appends the chunk and its message indexes to `out`, whose end is at `file_offset` of the file.
  ChunkIndex append_to(Bytes& out,
                       std::uint64_t file_offset,
                       Compression compression,
                       int level) const;

 private:
  Bytes records_;
  std::map<std::uint16_t, MessageIndex> indexes_;  ///< By channel.
  std::uint64_t first_log_time_ns_ = 0;
  std::uint64_t start_time_ns_ = 0;
  std::uint64_t end_time_ns_ = 0;
};

}  // namespace echomap::mcap
