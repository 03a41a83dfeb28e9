// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <optional>

#include "host/mcap/channel_table.hpp"
#include "host/mcap/record_file.hpp"
#include "host/mcap/records.hpp"

namespace echomap::mcap {

/// Reads an MCAP file, version 0 (https://mcap.dev/spec), from its beginning, in the order of the
/// file. It needs neither footer nor index, and memory for one chunk: at most 256 MiB compressed
/// and as much uncompressed. Every checksum that the file has is verified.
///
/// Where a file is damaged, everything whole before the damage is handed out, and then `next`
/// throws files::FileError, "path: byte N: what is wrong". Where it merely ends too early, as after
/// a writer was killed, it throws CutOffFile, which is derived from it.
class McapReader {
 public:
  /// Throws files::FileError where the file cannot be read or is not an MCAP file.
  explicit McapReader(const std::filesystem::path& path);

  /// The next message, attachment or metadata; none after the end of the data section. Once it has
  /// thrown, it throws the same each time.
  std::optional<Record> next();

  /// Share of the file that is read, 0 .. 1.
  double progress() const { return file_.progress(); }
  /// Empty where the file is cut off within its header.
  const HeaderInfo& header() const { return header_; }

 private:
  void read_header();
  std::optional<Record> next_in_file();
  std::optional<Record> next_in_chunk();
  std::optional<Record> take_record(const RecordHead& head);
  void open_chunk(std::uint64_t offset);
  void reject_disguised_index() const;
  void reject_index_of_lost_chunk() const;
  void end_data();

  RecordFile file_;
  HeaderInfo header_;
  ChannelTable channels_;
  Bytes content_;
  Bytes chunk_;                      ///< Records of the current chunk, uncompressed.
  std::size_t chunk_position_ = 0;   ///< Of the next record in it.
  std::uint64_t chunk_offset_ = 0;   ///< Of the chunk in the file.
  bool has_skipped_record_ = false;  ///< Since that chunk.
  bool is_ended_ = false;
  std::exception_ptr failure_;
};

}  // namespace echomap::mcap
