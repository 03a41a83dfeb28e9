// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>

#include "host/files/atomic_file.hpp"
#include "host/mcap/file_layout.hpp"
#include "host/mcap/records.hpp"

namespace echomap::mcap {

/// An MCAP file ends in the midst of a record or before the end of its data section, as one does
/// whose writer was killed. All records before that are whole.
class CutOffFile : public files::FileError {
 public:
  using files::FileError::FileError;
};

/// Kind, place and length of a record.
struct RecordHead {
  Opcode opcode{};
  std::uint64_t offset = 0;         ///< Of the record's first byte, from the start of the file.
  std::uint64_t content_bytes = 0;  ///< The head's own 9 bytes not included.
};

/// Reads the records of an MCAP file from its beginning, and nothing beyond the end of the file as
/// it was when it was opened. Every failure is a files::FileError; its text is
/// "path: byte N: what is wrong" where the contents are at fault.
class RecordFile {
 public:
  /// Throws files::FileError where the file cannot be read or does not begin as an MCAP file does.
  explicit RecordFile(std::filesystem::path path);

  /// Reads the head of the next record; none at the end of the file. `read_content` or
  /// `skip_content` has to follow. Throws CutOffFile where the file does not have the whole record.
  std::optional<RecordHead> next_head();
  /// Reads the content of the record into `content`, at most kMaxRecordBytes.
  void read_content(const RecordHead& head, Bytes& content);
  void skip_content(const RecordHead& head);

  /// CRC-32 of the file up to the record whose head was read last.
  std::uint32_t crc_before_record() const { return crc_before_record_; }
  /// Share of the file that is read, 0 .. 1.
  double progress() const;

  [[noreturn]] void fail(std::uint64_t offset, const std::string& what) const;
  /// Throws CutOffFile, or a plain FileError where the file has its closing magic: such a file is
  /// whole in its length, and damaged.
  [[noreturn]] void fail_cut_off(std::uint64_t offset, const std::string& what) const;

  /// Offset of the next byte that is read.
  std::uint64_t position() const { return position_; }

 private:
  void read_exactly(std::span<std::uint8_t> bytes);
  bool has_closing_magic();

  std::filesystem::path path_;
  std::uint64_t size_bytes_ = 0;
  std::ifstream stream_;
  std::uint64_t position_ = 0;
  bool is_closed_by_magic_ = false;
  std::uint32_t crc_ = 0;
  std::uint32_t crc_before_record_ = 0;
};

}  // namespace echomap::mcap
