// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/live_page/history.hpp"
#include "host/live_page/web_response.hpp"

namespace echomap::live_page {

/// A file of a run that can be downloaded.
struct RunFile {
  std::string name;
  std::uint64_t bytes = 0;
};

/// The regular files that lie directly in a run's folder, by name; none of a folder that is empty
/// or not there.
std::vector<RunFile> run_files(const std::filesystem::path& folder);

/// One of them, opened; null where there is none of that name. Nothing outside of the folder is
/// ever opened, whatever the name or the file is.
std::unique_ptr<BodySource> open_run_file(const std::filesystem::path& folder,
                                          std::string_view name);

/// What a file is, by its name.
std::string_view media_type_of(std::string_view name);

/// The messages of a run, each behind its length, without a copy of them all.
std::unique_ptr<BodySource> history_body(const History& history);

}  // namespace echomap::live_page
