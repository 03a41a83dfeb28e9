// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "host/exports/png_text.hpp"

namespace echomap::tests {

/// The tEXt chunks of a PNG file. Throws files::FileError where it is none or is cut short.
std::vector<exports::PngText> read_png_texts(const std::filesystem::path& path);

}  // namespace echomap::tests
