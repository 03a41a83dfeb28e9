// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace echomap::mcap {

/// First and last bytes of every file of MCAP version 0 (https://mcap.dev/spec, "Magic").
inline constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

/// Bytes before a record's content: one of its kind, eight of the content's length.
inline constexpr std::size_t kRecordHeadBytes = 9;

/// Largest record and largest uncompressed chunk that is written or read. It bounds the memory that
/// a damaged or malicious file can claim.
inline constexpr std::uint64_t kMaxRecordBytes = 256U << 20U;

/// Kinds of records, by the first byte of each (https://mcap.dev/spec, "Records").
enum class Opcode : std::uint8_t {
  kInvalid = 0x00,  ///< No record has it; a file that is padded with zeros seems to.
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0A,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
};

}  // namespace echomap::mcap
