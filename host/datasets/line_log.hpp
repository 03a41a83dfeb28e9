// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "host/datasets/line_reader.hpp"
#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// What one line of a format means.
class LineParser {
 public:
  LineParser() = default;
  virtual ~LineParser() = default;
  LineParser(const LineParser&) = delete;
  LineParser& operator=(const LineParser&) = delete;

  /// Appends the records of the line that `lines` gave last: none, one or several. Throws
  /// files::FileError with file and line.
  virtual void parse(const LineReader& lines,
                     std::string_view line,
                     std::vector<LogRecord>& records) = 0;
};

/// A log whose main file is read line by line; blank lines are skipped.
class LineLog : public LogReader {
 public:
  /// Throws files::FileError where the file cannot be opened.
  LineLog(const std::filesystem::path& path, std::unique_ptr<LineParser> parser);

  std::optional<LogRecord> next() override;
  double progress() const override { return lines_.progress(); }

 private:
  LineReader lines_;
  std::unique_ptr<LineParser> parser_;
  /// The records of the last line, and how many of them were given.
  std::vector<LogRecord> records_;
  std::size_t given_ = 0;
};

}  // namespace echomap::datasets
