// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace echomap::files {

/// Adds text to the end of a file that exists and flushes it to the disk. A program that is killed
/// in the midst of it leaves the first part of the text there, and so may an error: FileError.
void append_text(const std::filesystem::path& path, std::string_view text);

}  // namespace echomap::files
