// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_reader.hpp"

namespace echomap::datasets {

/// Whether the file's name ends so, or so and with .gz after it.
bool has_ending(const std::filesystem::path& path, std::string_view ending);

/// The file beside `path` that ends in `other` where `path` ends in `ending`, packed or not; empty
/// where there is none. Throws files::FileError where `path` does not end so.
std::optional<std::filesystem::path> companion_file(const std::filesystem::path& path,
                                                    std::string_view ending,
                                                    std::string_view other);

/// The same, but throws files::FileError that names the file where there is none.
std::filesystem::path required_companion(const std::filesystem::path& path,
                                         std::string_view ending,
                                         std::string_view other);

/// The lines of a file that go with those of another: blank lines and those that begin with # are
/// skipped.
class CompanionLines {
 public:
  explicit CompanionLines(const std::filesystem::path& path)
      : lines_(path, LineReader::Role::kCompanion) {}

  /// The fields of the next line, valid until the next call; empty at the end.
  std::optional<FieldCursor> next();
  /// The fields of the next line; throws files::FileError with what `needed_by` lacks at the end.
  FieldCursor require(const LineReader& needed_by);

 private:
  LineReader lines_;
};

}  // namespace echomap::datasets
