// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string_view>

namespace echomap::files {

/// A file could not be read or written; what() names the path and the reason.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Who may read a file that is written.
enum class Readers { kAll, kOwner };

/// Writes a file that is either whole or not there: bytes go to a temporary name beside it, and
/// `commit` renames. Without `commit`, or after an error, the temporary file is removed and an
/// older file of that name stays as it was. Every failure, a full disk included, throws FileError.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path, Readers readers = Readers::kAll);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view text);
  void write(std::span<const unsigned char> bytes);
  /// Flushes to the disk and gives the file its name.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_path_;
  int descriptor_ = -1;
};

/// Writes a whole text file at once.
void write_text_file(const std::filesystem::path& path,
                     std::string_view text,
                     Readers readers = Readers::kAll);

/// Reads a whole file.
std::string read_text_file(const std::filesystem::path& path);

}  // namespace echomap::files
