// SPDX-License-Identifier: MIT
#include "host/mcap/mcap_reader.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "host/mcap/chunk_compression.hpp"
#include "host/mcap/crc32.hpp"
#include "host/mcap/message_index.hpp"
#include "host/mcap/record_decoding.hpp"
#include "host/mcap/record_reader.hpp"

namespace echomap::mcap {

McapReader::McapReader(const std::filesystem::path& path) : file_(path) {
  try {
    read_header();
  } catch (const CutOffFile&) {
    failure_ = std::current_exception();
  }
}

void McapReader::read_header() {
  const auto head = file_.next_head();
  if (!head) {
    file_.fail_cut_off(file_.position(), "the file ends before its header");
  }
  if (head->opcode != Opcode::kHeader) {
    file_.fail(head->offset, "the first record is not a header");
  }
  file_.read_content(*head, content_);
  try {
    header_ = decode_header(content_);
  } catch (const RecordError& error) {
    file_.fail(head->offset, error.what());
  }
}

std::optional<Record> McapReader::next() {
  if (failure_ != nullptr) {
    std::rethrow_exception(failure_);
  }
  try {
    std::optional<Record> record;
    while (!record && !is_ended_) {
      record = chunk_position_ < chunk_.size() ? next_in_chunk() : next_in_file();
    }
    return record;
  } catch (const files::FileError&) {
    failure_ = std::current_exception();
    throw;
  }
}

std::optional<Record> McapReader::next_in_file() {
  const auto head = file_.next_head();
  if (!head) {
    file_.fail_cut_off(file_.position(), "the file ends before its data section does");
  }
  try {
    return take_record(*head);
  } catch (const RecordError& error) {
    file_.fail(head->offset, error.what());
  }
}

std::optional<Record> McapReader::take_record(const RecordHead& head) {
  if (head.opcode > Opcode::kDataEnd) {
    file_.skip_content(head);
    has_skipped_record_ = true;
    return std::nullopt;
  }
  file_.read_content(head, content_);
  switch (head.opcode) {
    case Opcode::kMessage:
      reject_disguised_index();
      [[fallthrough]];
    case Opcode::kSchema:
    case Opcode::kChannel:
      return channels_.take(head.opcode, content_);
    case Opcode::kAttachment:
      return decode_attachment(content_);
    case Opcode::kMetadata:
      return decode_metadata(content_);
    case Opcode::kChunk:
      open_chunk(head.offset);
      return std::nullopt;
    case Opcode::kMessageIndex:
      reject_index_of_lost_chunk();
      return std::nullopt;
    case Opcode::kDataEnd:
      end_data();
      return std::nullopt;
    default:
      throw RecordError("a record of kind " + std::to_string(static_cast<int>(head.opcode)) +
                        ", which does not belong into the data section");
  }
}

void McapReader::open_chunk(std::uint64_t offset) {
  const ChunkFields fields = decode_chunk(content_);
  if (fields.uncompressed_bytes > kMaxRecordBytes) {
    throw RecordError("a chunk of " + std::to_string(fields.uncompressed_bytes) +
                      " bytes uncompressed; at most " + std::to_string(kMaxRecordBytes) +
                      " are read");
  }
  Bytes records = decompress(fields.records, fields.compression, fields.uncompressed_bytes);
  if (fields.uncompressed_crc != 0 && fields.uncompressed_crc != crc32_of(records)) {
    throw RecordError("the checksum of the chunk differs");
  }
  chunk_ = std::move(records);
  chunk_position_ = 0;
  chunk_offset_ = offset;
  has_skipped_record_ = false;
}

/// A message outside of chunks has no checksum of its own; one wrong bit makes one of an index.
void McapReader::reject_disguised_index() const {
  if (is_index_into(content_, chunk_)) {
    throw RecordError("a message index in the place of a message");
  }
}

/// Unknown records are allowed, and a chunk with one wrong bit looks like one. Its indexes give it
/// away before the next chunk is handed out.
void McapReader::reject_index_of_lost_chunk() const {
  const MessageIndex index = decode_message_index(content_);
  if (has_skipped_record_ && !index.entries.empty() && !points_into(index, chunk_)) {
    throw RecordError("a message index whose chunk is damaged");
  }
}

void McapReader::end_data() {
  const std::uint32_t crc = decode_data_end(content_);
  if (crc != 0 && crc != file_.crc_before_record()) {
    throw RecordError("the checksum of the data section differs: something before is damaged");
  }
  is_ended_ = true;
}

std::optional<Record> McapReader::next_in_chunk() {
  const std::size_t position = chunk_position_;
  try {
    RecordReader reader(std::span<const std::uint8_t>(chunk_).subspan(position));
    const auto opcode = static_cast<Opcode>(reader.number<std::uint8_t>());
    const auto content = reader.bytes(reader.number<std::uint64_t>());
    chunk_position_ = chunk_.size() - reader.rest().size();
    return channels_.take(opcode, content);
  } catch (const RecordError& error) {
    file_.fail(chunk_offset_,
               "in the chunk, at its byte " + std::to_string(position) + ": " + error.what());
  }
}

}  // namespace echomap::mcap
