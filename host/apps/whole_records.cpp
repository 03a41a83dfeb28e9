// SPDX-License-Identifier: MIT
#include "host/apps/whole_records.hpp"

#include <string>

#include <spdlog/spdlog.h>

#include "host/datasets/line_reader.hpp"
#include "host/datasets/open_log.hpp"

namespace echomap::apps {

std::unique_ptr<datasets::LogReader> open_reported_log(const std::filesystem::path& path,
                                                       std::string_view format) {
  auto log = datasets::open_log(path, format);
  for (const std::string& note : log->notes()) {
    spdlog::warn("{}: {}", path.string(), note);
  }
  return log;
}

std::optional<datasets::LogRecord> next_whole_record(datasets::LogReader& log) {
  try {
    return log.next();
  } catch (const datasets::CutOffLine& half) {
    spdlog::warn("the end of the log is incomplete; everything before it was read: {}",
                 half.what());
    return std::nullopt;
  }
}

}  // namespace echomap::apps
