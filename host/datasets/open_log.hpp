// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// A format that can be read.
struct LogFormat {
  std::string_view name;
  std::string_view description;
  std::unique_ptr<LogReader> (*open)(const std::filesystem::path& path);
};

/// Every format, by name.
const std::vector<LogFormat>& log_formats();

/// What to tell someone who names a format that is none, with the nearest one; empty where it is
/// one.
std::string unknown_format(std::string_view name);

/// The format that the name of a file or its first lines plainly say; empty where they do not.
/// Throws files::FileError where the file cannot be read.
std::optional<std::string_view> recognised_format(const std::filesystem::path& path);

/// Opens a log; an empty format is recognised. Throws files::FileError where there is no such
/// format (with the nearest one), none is recognised (with all of them) or the log cannot be read.
std::unique_ptr<LogReader> open_log(const std::filesystem::path& path, std::string_view format);

}  // namespace echomap::datasets
