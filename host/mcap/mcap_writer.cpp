// SPDX-License-Identifier: MIT
#include "host/mcap/mcap_writer.hpp"

#include <exception>
#include <stdexcept>
#include <string>

#include "host/mcap/file_layout.hpp"
#include "host/mcap/record_encoding.hpp"

namespace echomap::mcap {

namespace {

/// So that a chunk just below its limit and one message more are far below what readers take.
constexpr std::size_t kMaxChunkBytes = 64U << 20U;
constexpr std::size_t kMaxMessageBytes = 64U << 20U;
constexpr std::size_t kMaxAttachmentBytes = 255U << 20U;

void require_range(bool holds, const char* field, std::uint64_t value, const char* range) {
  if (!holds) {
    throw std::invalid_argument(std::string(field) + " = " + std::to_string(value) +
                                " is outside " + range);
  }
}

McapWriterParams validate_writer_params(const McapWriterParams& params) {
  require_range(params.chunk_bytes >= 1 && params.chunk_bytes <= kMaxChunkBytes,
                "chunk_bytes",
                params.chunk_bytes,
                "1 .. 67108864");
  require_range(
      params.chunk_duration_ns >= 1, "chunk_duration_ns", params.chunk_duration_ns, "1 ..");
  if (params.compression_level < 1 || params.compression_level > 19) {
    throw std::invalid_argument("compression_level = " + std::to_string(params.compression_level) +
                                " is outside 1 .. 19");
  }
  return params;
}

std::size_t size_of(const Metadata& metadata) {
  std::size_t bytes = metadata.name.size();
  for (const auto& [name, text] : metadata.entries) {
    bytes += name.size() + text.size() + 2 * sizeof(std::uint32_t);
  }
  return bytes;
}

}  // namespace

McapWriter::McapWriter(const HeaderInfo& header, const McapWriterParams& params)
    : params_(validate_writer_params(params)) {
  output_.pending().assign(kMagic.begin(), kMagic.end());
  append_header(output_.pending(), header);
}

McapWriter::~McapWriter() {
  try {
    finish();
  } catch (const std::exception&) {
    // Whoever wants to know calls finish().
  }
}

void McapWriter::open(const std::filesystem::path& path) {
  output_.open(path);
  close_chunk();
  output_.write_out();
}

std::uint16_t McapWriter::add_schema(const Schema& schema) {
  require_unfinished();
  const std::uint16_t id = summary_.add_schema(schema);
  chunk_.add_schema(id, schema);
  return id;
}

std::uint16_t McapWriter::add_channel(const ChannelInfo& channel) {
  require_unfinished();
  const std::uint16_t id = summary_.add_channel(channel);
  chunk_.add_channel(id, channel);
  next_sequences_.push_back(0);
  return id;
}

void McapWriter::write(std::uint16_t channel_id,
                       std::uint64_t log_time_ns,
                       std::uint64_t publish_time_ns,
                       std::span<const std::uint8_t> data) {
  require_unfinished();
  if (!summary_.has_channel(channel_id)) {
    throw std::invalid_argument("there is no channel " + std::to_string(channel_id));
  }
  require_range(data.size() <= kMaxMessageBytes, "message bytes", data.size(), "0 .. 67108864");
  const bool is_late = chunk_.has_messages() && log_time_ns > chunk_.first_log_time_ns() &&
                       log_time_ns - chunk_.first_log_time_ns() >= params_.chunk_duration_ns;
  if (is_late) {
    close_chunk();
  }
  const std::uint32_t sequence = next_sequences_.at(channel_id - 1U)++;
  chunk_.add_message({channel_id, sequence, log_time_ns, publish_time_ns, data});
  summary_.count_message(channel_id, log_time_ns);
  const bool is_full = chunk_.records().size() >= params_.chunk_bytes;
  if (is_full) {
    close_chunk();
  }
  if (is_late || is_full) {
    output_.write_out();
  }
}

void McapWriter::attach(const Attachment& attachment) {
  require_unfinished();
  const std::size_t bytes =
      attachment.data.size() + attachment.name.size() + attachment.media_type.size();
  require_range(bytes <= kMaxAttachmentBytes, "attachment bytes", bytes, "0 .. 267386880");
  const std::uint64_t offset = output_.size_bytes();
  append_attachment(output_.pending(), attachment);
  summary_.add_attachment({offset,
                           output_.size_bytes() - offset,
                           attachment.log_time_ns,
                           attachment.create_time_ns,
                           attachment.data.size(),
                           attachment.name,
                           attachment.media_type});
  output_.write_out();
}

void McapWriter::add_metadata(const Metadata& metadata) {
  require_unfinished();
  const std::size_t bytes = size_of(metadata);
  require_range(bytes <= kMaxAttachmentBytes, "metadata bytes", bytes, "0 .. 267386880");
  const std::uint64_t offset = output_.size_bytes();
  append_metadata(output_.pending(), metadata);
  summary_.add_metadata({offset, output_.size_bytes() - offset, metadata.name});
  output_.write_out();
}

void McapWriter::flush() {
  close_chunk();
  output_.write_out();
}

void McapWriter::finish() {
  if (!is_finished_) {
    close_chunk();
    append_unused_definitions();
    append_data_end(output_.pending(), output_.crc());
    const std::uint64_t summary_offset = output_.size_bytes();
    summary_.append_to(output_.pending(), summary_offset);
    is_finished_ = true;
  }
  output_.write_out();
}

void McapWriter::require_unfinished() const {
  if (is_finished_) {
    throw std::logic_error("nothing can be added to an MCAP file that is finished");
  }
}

/// Definitions without a message wait for the next chunk, which will be the first to use them.
void McapWriter::close_chunk() {
  if (!chunk_.has_messages()) {
    return;
  }
  summary_.add_chunk(chunk_.append_to(
      output_.pending(), output_.size_bytes(), params_.compression, params_.compression_level));
  chunk_ = ChunkBuilder();
}

/// Outside of a chunk: one without messages has no times, and readers take the times of the file
/// from those of its chunks.
void McapWriter::append_unused_definitions() {
  const Bytes& records = chunk_.records();
  output_.pending().insert(output_.pending().end(), records.begin(), records.end());
  chunk_ = ChunkBuilder();
}

}  // namespace echomap::mcap
