// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <sim_avr.h>
#include <string>

namespace echomap::emulator {

/// The chip that an AVR program was linked for, as in -mmcu: "atmega328p". avr-gcc's start-up code
/// notes it in every ELF file. Throws std::runtime_error with the path and what is wrong with it.
std::string chip_of_elf(const std::filesystem::path& elf);

/// Loads an AVR program into the flash of `avr`; `elf` is one for which `chip_of_elf` had an
/// answer. Throws std::runtime_error with the path and what is wrong with it.
void load_elf_program(const std::filesystem::path& elf, avr_t& avr);

}  // namespace echomap::emulator
