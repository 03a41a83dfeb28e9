// SPDX-License-Identifier: MIT
#include "host/mcap/summary.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>

#include "host/mcap/crc32.hpp"
#include "host/mcap/file_layout.hpp"
#include "host/mcap/record_encoding.hpp"
#include "host/mcap/record_writer.hpp"

namespace echomap::mcap {

namespace {

/// Records of one kind that follow each other in the summary.
struct SummaryGroup {
  std::uint8_t opcode = 0;
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
};

std::uint16_t next_identifier(std::size_t count, const char* kind) {
  if (count >= std::numeric_limits<std::uint16_t>::max()) {
    throw std::length_error(std::string("an MCAP file has at most 65535 ") + kind);
  }
  return static_cast<std::uint16_t>(count + 1);
}

void append_offsets(Bytes& out, const std::vector<SummaryGroup>& groups) {
  for (const SummaryGroup& group : groups) {
    RecordWriter record(out, Opcode::kSummaryOffset);
    record.number(group.opcode);
    record.number(group.offset);
    record.number(group.bytes);
  }
}

/// The footer's checksum includes the footer's own first bytes, its length among them.
void append_footer(Bytes& out, std::size_t start, std::uint64_t offset, std::uint64_t groups_at) {
  constexpr std::uint64_t kFooterBytes = 20;
  append_number(out, static_cast<std::uint8_t>(Opcode::kFooter));
  append_number(out, kFooterBytes);
  append_number(out, offset);
  append_number(out, groups_at);
  append_number(out, crc32_of(std::span(out).subspan(start)));
  out.insert(out.end(), kMagic.begin(), kMagic.end());
}

}  // namespace

std::uint16_t Summary::add_schema(Schema schema) {
  const std::uint16_t id = next_identifier(schemas_.size(), "schemas");
  schemas_.push_back(std::move(schema));
  return id;
}

std::uint16_t Summary::add_channel(ChannelInfo channel) {
  if (channel.schema_id > schemas_.size()) {
    throw std::invalid_argument("channel " + channel.topic + ": there is no schema " +
                                std::to_string(channel.schema_id));
  }
  const std::uint16_t id = next_identifier(channels_.size(), "channels");
  channels_.push_back(std::move(channel));
  message_counts_.push_back(0);
  return id;
}

void Summary::count_message(std::uint16_t channel_id, std::uint64_t log_time_ns) {
  const bool is_first = message_count_ == 0;
  message_start_time_ns_ = is_first ? log_time_ns : std::min(message_start_time_ns_, log_time_ns);
  message_end_time_ns_ = std::max(message_end_time_ns_, log_time_ns);
  ++message_count_;
  ++message_counts_.at(channel_id - 1U);
}

void Summary::append_schemas(Bytes& out) const {
  for (std::size_t i = 0; i < schemas_.size(); ++i) {
    append_schema(out, static_cast<std::uint16_t>(i + 1), schemas_[i]);
  }
}

void Summary::append_channels(Bytes& out) const {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    append_channel(out, static_cast<std::uint16_t>(i + 1), channels_[i]);
  }
}

void Summary::append_statistics(Bytes& out) const {
  RecordWriter record(out, Opcode::kStatistics);
  record.number(message_count_);
  record.number(static_cast<std::uint16_t>(schemas_.size()));
  record.number(static_cast<std::uint32_t>(channels_.size()));
  record.number(static_cast<std::uint32_t>(attachments_.size()));
  record.number(static_cast<std::uint32_t>(metadata_.size()));
  record.number(static_cast<std::uint32_t>(chunks_.size()));
  record.number(message_start_time_ns_);
  record.number(message_end_time_ns_);
  std::uint16_t channel_id = 0;
  record.list(message_counts_, [&](std::uint64_t count) {
    record.number(++channel_id);
    record.number(count);
  });
}

void Summary::append_chunks(Bytes& out) const {
  for (const ChunkIndex& chunk : chunks_) {
    RecordWriter record(out, Opcode::kChunkIndex);
    record.number(chunk.message_start_time_ns);
    record.number(chunk.message_end_time_ns);
    record.number(chunk.chunk_offset);
    record.number(chunk.chunk_bytes);
    record.list(chunk.message_index_offsets, [&](const auto& entry) {
      record.number(entry.first);
      record.number(entry.second);
    });
    record.number(chunk.message_index_bytes);
    record.text(chunk.compression);
    record.number(chunk.compressed_bytes);
    record.number(chunk.uncompressed_bytes);
  }
}

void Summary::append_attachments(Bytes& out) const {
  for (const AttachmentIndex& attachment : attachments_) {
    RecordWriter record(out, Opcode::kAttachmentIndex);
    record.number(attachment.offset);
    record.number(attachment.record_bytes);
    record.number(attachment.log_time_ns);
    record.number(attachment.create_time_ns);
    record.number(attachment.data_bytes);
    record.text(attachment.name);
    record.text(attachment.media_type);
  }
}

void Summary::append_metadata_indexes(Bytes& out) const {
  for (const MetadataIndex& metadata : metadata_) {
    RecordWriter record(out, Opcode::kMetadataIndex);
    record.number(metadata.offset);
    record.number(metadata.record_bytes);
    record.text(metadata.name);
  }
}

void Summary::append_to(Bytes& out, std::uint64_t file_offset) const {
  const std::size_t start = out.size();
  const auto offset_of = [&](std::size_t position) { return file_offset + position - start; };
  std::vector<SummaryGroup> groups;
  for (const auto append : {&Summary::append_schemas,
                            &Summary::append_channels,
                            &Summary::append_statistics,
                            &Summary::append_chunks,
                            &Summary::append_attachments,
                            &Summary::append_metadata_indexes}) {
    const std::size_t group_start = out.size();
    (this->*append)(out);
    if (out.size() != group_start) {
      groups.push_back({out[group_start], offset_of(group_start), out.size() - group_start});
    }
  }
  const std::uint64_t groups_at = offset_of(out.size());
  append_offsets(out, groups);
  append_footer(out, start, file_offset, groups_at);
}

}  // namespace echomap::mcap
