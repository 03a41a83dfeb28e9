// SPDX-License-Identifier: MIT
#include "host/apps/whole_records.hpp"

#include <spdlog/spdlog.h>

#include "host/datasets/line_reader.hpp"

namespace echomap::apps {

std::optional<datasets::LogRecord> next_whole_record(datasets::LogReader& log) {
  try {
    return log.next();
  } catch (const datasets::CutOffLine& half) {
    spdlog::warn("the last line is incomplete; everything before it was read: {}", half.what());
    return std::nullopt;
  }
}

}  // namespace echomap::apps
