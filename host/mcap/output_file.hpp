// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "host/mcap/records.hpp"

namespace echomap::mcap {

/// A file that grows by whole blocks of bytes, which are collected in memory first. What could not
/// be written stays in memory for the next attempt, and the file ends at the last whole block.
class OutputFile {
 public:
  OutputFile() = default;
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Creates the file, or empties it. Throws files::FileError where that fails, std::logic_error
  /// where this has a file already.
  void open(const std::filesystem::path& path);

  /// What is to be written next; append to it.
  Bytes& pending() { return pending_; }
  /// Hands all pending bytes to the operating system, in one call where the disk takes them all.
  /// Does nothing before `open`. Throws files::FileError with path and reason where it fails.
  void write_out();

  std::uint64_t written_bytes() const { return written_bytes_; }
  /// Bytes of the file once all that is pending is written.
  std::uint64_t size_bytes() const { return written_bytes_ + pending_.size(); }
  /// CRC-32 of all of them.
  std::uint32_t crc() const;

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  Bytes pending_;
  std::uint64_t written_bytes_ = 0;
  std::uint32_t written_crc_ = 0;
};

}  // namespace echomap::mcap
