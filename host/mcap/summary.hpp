// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/mcap/records.hpp"

namespace echomap::mcap {

/// Where a chunk and its message indexes are. Offsets are in bytes from the start of the file, a
/// length includes a record's kind and length.
struct ChunkIndex {
  std::uint64_t message_start_time_ns = 0;
  std::uint64_t message_end_time_ns = 0;
  std::uint64_t chunk_offset = 0;
  std::uint64_t chunk_bytes = 0;
  std::map<std::uint16_t, std::uint64_t> message_index_offsets;  ///< By channel.
  std::uint64_t message_index_bytes = 0;                         ///< Of all of them together.
  std::string compression;
  std::uint64_t compressed_bytes = 0;
  std::uint64_t uncompressed_bytes = 0;
};

/// Where an attachment is, and its fields without the data.
struct AttachmentIndex {
  std::uint64_t offset = 0;
  std::uint64_t record_bytes = 0;
  std::uint64_t log_time_ns = 0;
  std::uint64_t create_time_ns = 0;
  std::uint64_t data_bytes = 0;
  std::string name;
  std::string media_type;
};

/// Where a metadata record is.
struct MetadataIndex {
  std::uint64_t offset = 0;
  std::uint64_t record_bytes = 0;
  std::string name;
};

/// What readers find at the end of a file: all definitions again, counts, and where chunks,
/// attachments and metadata are.
class Summary {
 public:
  /// Both return the identifier of the new one; the first has 1. They throw std::length_error where
  /// there are 65535 already, and `add_channel` std::invalid_argument for an unknown schema.
  std::uint16_t add_schema(Schema schema);
  std::uint16_t add_channel(ChannelInfo channel);
  /// Counts one message of a channel that is there.
  void count_message(std::uint16_t channel_id, std::uint64_t log_time_ns);
  void add_chunk(ChunkIndex index) { chunks_.push_back(std::move(index)); }
  void add_attachment(AttachmentIndex index) { attachments_.push_back(std::move(index)); }
  void add_metadata(MetadataIndex index) { metadata_.push_back(std::move(index)); }

  bool has_channel(std::uint16_t id) const { return id != 0 && id <= channels_.size(); }

  /// Appends the summary, its offsets, the footer and the closing magic to `out`, whose end is at
  /// `file_offset` of the file.
  void append_to(Bytes& out, std::uint64_t file_offset) const;

 private:
  void append_statistics(Bytes& out) const;
  void append_schemas(Bytes& out) const;
  void append_channels(Bytes& out) const;
  void append_chunks(Bytes& out) const;
  void append_attachments(Bytes& out) const;
  void append_metadata_indexes(Bytes& out) const;

  std::vector<Schema> schemas_;
  std::vector<ChannelInfo> channels_;
  std::vector<std::uint64_t> message_counts_;  ///< By channel.
  std::uint64_t message_count_ = 0;
  std::uint64_t message_start_time_ns_ = 0;
  std::uint64_t message_end_time_ns_ = 0;
  std::vector<ChunkIndex> chunks_;
  std::vector<AttachmentIndex> attachments_;
  std::vector<MetadataIndex> metadata_;
};

}  // namespace echomap::mcap
