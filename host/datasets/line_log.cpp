// SPDX-License-Identifier: MIT
#include "host/datasets/line_log.hpp"

#include <utility>

namespace echomap::datasets {

LineLog::LineLog(const std::filesystem::path& path, std::unique_ptr<LineParser> parser)
    : lines_(path), parser_(std::move(parser)) {}

std::optional<LogRecord> LineLog::next() {
  while (given_ == records_.size()) {
    records_.clear();
    given_ = 0;
    const auto line = lines_.next();
    if (!line) {
      return std::nullopt;
    }
    if (line->find_first_not_of(" \t") != std::string_view::npos) {
      parser_->parse(lines_, *line, records_);
    }
  }
  return std::move(records_[given_++]);
}

}  // namespace echomap::datasets
