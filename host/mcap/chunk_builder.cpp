// SPDX-License-Identifier: MIT
#include "host/mcap/chunk_builder.hpp"

#include <algorithm>

#include "host/mcap/crc32.hpp"
#include "host/mcap/file_layout.hpp"
#include "host/mcap/record_writer.hpp"

namespace echomap::mcap {

namespace {

void append_message_index(Bytes& out, MessageIndex index) {
  // A reader may look a time up by halving, so that the entries have to be in order of time.
  std::sort(index.entries.begin(), index.entries.end());
  RecordWriter record(out, Opcode::kMessageIndex);
  record.number(index.channel_id);
  record.list(index.entries, [&](const auto& entry) {
    record.number(entry.first);
    record.number(entry.second);
  });
}

}  // namespace

void ChunkBuilder::add_message(const MessageFields& message) {
  if (!has_messages()) {
    first_log_time_ns_ = message.log_time_ns;
    start_time_ns_ = message.log_time_ns;
  }
  start_time_ns_ = std::min(start_time_ns_, message.log_time_ns);
  end_time_ns_ = std::max(end_time_ns_, message.log_time_ns);
  MessageIndex& index = indexes_[message.channel_id];
  index.channel_id = message.channel_id;
  index.entries.emplace_back(message.log_time_ns, records_.size());
  append_message(records_, message);
}

ChunkIndex ChunkBuilder::append_to(Bytes& out,
                                   std::uint64_t file_offset,
                                   Compression compression,
                                   int level) const {
  const std::size_t start = out.size();
  const Bytes compressed = compress(records_, compression, level);
  ChunkIndex index;
  index.message_start_time_ns = start_time_ns_;
  index.message_end_time_ns = end_time_ns_;
  index.chunk_offset = file_offset;
  index.compression = name_of(compression);
  index.compressed_bytes = compressed.size();
  index.uncompressed_bytes = records_.size();
  {
    RecordWriter record(out, Opcode::kChunk);
    record.number(start_time_ns_);
    record.number(end_time_ns_);
    record.number(index.uncompressed_bytes);
    record.number(crc32_of(records_));
    record.text(index.compression);
    record.number(index.compressed_bytes);
    record.bytes(compressed);
  }
  index.chunk_bytes = out.size() - start;
  for (const auto& [channel_id, message_index] : indexes_) {
    index.message_index_offsets[channel_id] = file_offset + out.size() - start;
    append_message_index(out, message_index);
  }
  index.message_index_bytes = out.size() - start - index.chunk_bytes;
  return index;
}

}  // namespace echomap::mcap
