// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/datasets/log_record.hpp"

namespace echomap::datasets {

/// A log that is being read, record by record and in bounded memory.
class LogReader {
 public:
  LogReader() = default;
  virtual ~LogReader() = default;
  LogReader(const LogReader&) = delete;
  LogReader& operator=(const LogReader&) = delete;

  /// The next record; empty at the end. Throws files::FileError, whose text begins `file:line: `
  /// where the log is not what its format says: CutOffLine where that is half a line, or half a
  /// record of a binary file, at its end, behind all other records.
  virtual std::optional<LogRecord> next() = 0;
  /// The share of the log that has been read, 0 .. 1.
  virtual double progress() const = 0;
  /// What of the log is not used or was assumed, one sentence each, for the user to read.
  virtual std::vector<std::string> notes() const { return {}; }
};

}  // namespace echomap::datasets
