// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "host/mcap/record_encoding.hpp"
#include "host/mcap/records.hpp"

namespace echomap::mcap {

/// The fields of a chunk record; `records` are compressed and belong to the record's content.
struct ChunkFields {
  std::uint64_t uncompressed_bytes = 0;
  std::uint32_t uncompressed_crc = 0;  ///< 0: the chunk has none.
  std::string compression;             ///< "" (none), "zstd" or "lz4".
  std::span<const std::uint8_t> records;
};

/// Each function takes the content of one record apart. They throw RecordError where a field does
/// not fit, and `decode_attachment` where the checksum of an attachment differs.
HeaderInfo decode_header(std::span<const std::uint8_t> content);
std::pair<std::uint16_t, Schema> decode_schema(std::span<const std::uint8_t> content);
std::pair<std::uint16_t, ChannelInfo> decode_channel(std::span<const std::uint8_t> content);
MessageFields decode_message(std::span<const std::uint8_t> content);
ChunkFields decode_chunk(std::span<const std::uint8_t> content);
Attachment decode_attachment(std::span<const std::uint8_t> content);
Metadata decode_metadata(std::span<const std::uint8_t> content);
/// Returns the checksum of all before the end of the data section; 0: the file has none.
std::uint32_t decode_data_end(std::span<const std::uint8_t> content);

}  // namespace echomap::mcap
