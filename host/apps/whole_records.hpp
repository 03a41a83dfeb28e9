// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/datasets/log_reader.hpp"

namespace echomap::apps {

/// The next record of a log; empty at its end, and where whoever wrote it was cut off in its last
/// line, which is told. Throws files::FileError where the log is damaged before.
std::optional<datasets::LogRecord> next_whole_record(datasets::LogReader& log);

}  // namespace echomap::apps
