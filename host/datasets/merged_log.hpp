// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "host/datasets/line_reader.hpp"
#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Logs of one clock as one log: the record with the earliest stamp comes first, of equal ones that
/// of the log that was named first. A record without stamp stays behind the one before it.
class MergedLog : public LogReader {
 public:
  explicit MergedLog(std::vector<std::unique_ptr<LogReader>> logs);

  std::optional<LogRecord> next() override;
  /// The mean of the logs'.
  double progress() const override;

 private:
  struct Source {
    std::unique_ptr<LogReader> log;
    /// What comes next, read when it is first needed.
    std::optional<LogRecord> head;
    bool has_ended = false;
  };
  /// Half a line at the end of one log waits until all have ended.
  void fill(Source& source);
  Source* earliest();

  std::vector<Source> sources_;
  std::optional<CutOffLine> cut_off_;
};

}  // namespace echomap::datasets
