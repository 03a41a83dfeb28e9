// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "host/mcap/chunk_builder.hpp"
#include "host/mcap/chunk_compression.hpp"
#include "host/mcap/output_file.hpp"
#include "host/mcap/records.hpp"
#include "host/mcap/summary.hpp"

namespace echomap::mcap {

/// Settings of a writer: when it writes a chunk, and how it compresses it.
struct McapWriterParams {
  /// A chunk is written as soon as it has so many uncompressed bytes; 1 .. 67108864.
  std::size_t chunk_bytes = 1U << 20U;
  /// A chunk is written when a message comes that is logged so much later than the chunk's first,
  /// nanoseconds, at least 1. A program that is killed loses at most this much.
  std::uint64_t chunk_duration_ns = 4'000'000'000;
  Compression compression = Compression::kZstd;
  int compression_level = 3;  ///< Of zstd, 1 .. 19; 3 is zstd's own default.
};

/// Writes an MCAP file, version 0 (https://mcap.dev/spec): messages in chunks, with indexes and
/// checksums. Nothing touches the disk before `open`, and all that came before it is in the file,
/// too. The same calls give the same bytes.
///
/// Each flush is with the operating system when it returns: a program that is killed loses nothing
/// that was flushed (a power cut may), and the file that it leaves is readable from its beginning.
///
/// Functions that write to the disk throw files::FileError with the file and the reason. What they
/// were given is then not lost: it stays in memory, the file ends at the last whole chunk, and
/// every later flush tries again to write what is missing.
class McapWriter {
 public:
  /// Throws std::invalid_argument with the field, its value and its range where a parameter is
  /// invalid.
  explicit McapWriter(const HeaderInfo& header, const McapWriterParams& params = {});
  /// Ends the file, without an exception where that fails.
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// Creates the file, or empties it, and writes what there is so far. Where the file cannot be
  /// created, another path may be opened.
  void open(const std::filesystem::path& path);

  /// Both define something for the messages that follow, and return its identifier in the file.
  /// `add_channel` throws std::invalid_argument where the channel's schema is unknown.
  std::uint16_t add_schema(const Schema& schema);
  std::uint16_t add_channel(const ChannelInfo& channel);
  /// Adds a message; its sequence number counts the messages of its channel from 0. Throws
  /// std::invalid_argument for an unknown channel and for more than 64 MiB.
  void write(std::uint16_t channel_id,
             std::uint64_t log_time_ns,
             std::uint64_t publish_time_ns,
             std::span<const std::uint8_t> data);
  /// Both are written at once, so that they come before the messages that are still collected. They
  /// throw std::invalid_argument for more than 255 MiB.
  void attach(const Attachment& attachment);
  void add_metadata(const Metadata& metadata);

  /// Writes the messages that are collected so far, as a chunk of its own.
  void flush();
  /// Writes what is left and the file's summary. After it nothing can be added (std::logic_error);
  /// where it fails it may be called again.
  void finish();

  /// Bytes of the file that the operating system has.
  std::uint64_t bytes_written() const { return output_.written_bytes(); }

 private:
  void require_unfinished() const;
  void close_chunk();
  void append_unused_definitions();

  McapWriterParams params_;
  OutputFile output_;
  Summary summary_;
  ChunkBuilder chunk_;
  std::vector<std::uint32_t> next_sequences_;  ///< By channel.
  bool is_finished_ = false;
};

}  // namespace echomap::mcap
