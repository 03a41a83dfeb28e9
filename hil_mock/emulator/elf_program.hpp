// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <sim_avr.h>

namespace echomap::emulator {

/// Loads the program of an AVR ELF file into the flash of `avr`. Throws std::runtime_error with the
/// path and what is wrong with it.
void load_elf_program(const std::filesystem::path& elf, avr_t& avr);

}  // namespace echomap::emulator
