// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "host/exports/picture.hpp"

namespace echomap::papers {

/// Writes a picture to `file`, whose folder is made, and returns the bytes of the PNG file. Throws
/// files::FileError.
std::vector<std::uint8_t> write_picture(const exports::Picture& picture,
                                        const std::filesystem::path& file,
                                        const std::vector<exports::PngText>& texts = {});

}  // namespace echomap::papers
