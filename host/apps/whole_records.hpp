// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "host/datasets/log_reader.hpp"

namespace echomap::apps {

/// Opens a log as datasets::open_log does, and warns of what of it is not used.
std::unique_ptr<datasets::LogReader> open_reported_log(const std::filesystem::path& path,
                                                       std::string_view format);

/// The next record of a log; empty at its end, and where whoever wrote it was cut off in its last
/// line or record, which is told. Throws files::FileError where the log is damaged before.
std::optional<datasets::LogRecord> next_whole_record(datasets::LogReader& log);

}  // namespace echomap::apps
