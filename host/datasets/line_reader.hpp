// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/files/atomic_file.hpp"

struct gzFile_s;

namespace echomap::datasets {

/// The last line of a file has no end and is not what its format says, or a binary file ends within
/// a record: whoever wrote it was cut off in its midst. All before it is whole.
class CutOffLine : public files::FileError {
 public:
  using FileError::FileError;
};

/// Reads a text file, plain or gz, line by line in bounded memory: a quarter of a megabyte for
/// itself and what zlib needs, however large the file or what is packed in it.
class LineReader {
 public:
  /// A longer line is an error. The longest of a public log that we know has 7 kB.
  static constexpr std::size_t kMaxLineBytes = 65536;

  /// A companion's lines belong to those of another file, which goes on where they are cut off.
  enum class Role { kMain, kCompanion };

  /// Throws files::FileError where the file cannot be opened.
  explicit LineReader(std::filesystem::path path, Role role = Role::kMain);

  /// The next line without its end (LF or CR LF; the last may lack it), valid until the next call;
  /// empty at the end of the file. Throws files::FileError with `file:line: ` for a line that is
  /// too long or holds a zero byte, and for gz data that are cut off or damaged.
  std::optional<std::string_view> next();

  const std::filesystem::path& path() const { return path_; }
  /// Number of the line that `next` gave last, from 1; 0 before.
  std::size_t line_number() const { return line_number_; }
  /// The share of the file's bytes that have been read, 0 .. 1.
  double progress() const;
  /// Throws files::FileError with the text `file:line: message` for the line given last; CutOffLine
  /// where that is the main file's last of several and lacks its end.
  [[noreturn]] void fail(const std::string& message) const;

 private:
  struct Close {
    void operator()(gzFile_s* file) const;
  };

  /// Moves what is left to the front of the buffer and reads on; false at the end of the file.
  bool fill();
  std::string_view checked(std::string_view line) const;

  std::filesystem::path path_;
  Role role_;
  double file_bytes_ = 0.0;
  std::unique_ptr<gzFile_s, Close> file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t line_number_ = 0;
  bool lacks_end_ = false;  ///< The line given last.
};

}  // namespace echomap::datasets
