// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace echomap::unicorn {

/// The bytes that an ELF file puts into a chip's memory at `address`.
struct ProgramSegment {
  std::uint32_t address = 0;
  std::vector<std::uint8_t> bytes;
};

/// Reads the loaded segments of an ARM ELF file, by their physical addresses. Throws
/// std::runtime_error with the path and what is wrong with it.
std::vector<ProgramSegment> read_elf_program(const std::filesystem::path& elf);

}  // namespace echomap::unicorn
