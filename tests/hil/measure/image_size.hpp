// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace echomap::tests {

/// What an image takes of its chip.
struct ImageSize {
  std::uint64_t flash_bytes = 0;
  std::uint64_t ram_bytes = 0;  ///< Static.
};

/// By the sections of an ELF file. Throws std::runtime_error where it is none.
ImageSize size_of_image(const std::filesystem::path& elf);

}  // namespace echomap::tests
