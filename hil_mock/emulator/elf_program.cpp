// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/elf_program.hpp"

#include <array>
#include <cstdlib>
#include <fstream>
#include <sim_elf.h>
#include <span>
#include <stdexcept>
#include <string>

namespace echomap::emulator {
namespace {

constexpr std::size_t kMachineAt = 18;  // e_machine of the ELF header
constexpr unsigned char kMachineAvr = 83;

[[noreturn]] void fail(const std::filesystem::path& elf, const std::string& what) {
  throw std::runtime_error(elf.string() + ": " + what);
}

/// simavr's reader trusts its input, so look at the file first.
void check_is_avr_elf(const std::filesystem::path& elf) {
  std::ifstream file(elf, std::ios::binary);
  if (!file) {
    fail(elf, "cannot be opened");
  }
  std::array<char, kMachineAt + 2> header{};
  file.read(header.data(), header.size());
  const bool is_elf = file && std::string(header.data(), 4) ==
                                  "\x7F"
                                  "ELF";
  if (!is_elf || static_cast<unsigned char>(header[kMachineAt]) != kMachineAvr) {
    fail(elf, "is no ELF file of an AVR program");
  }
}

void free_firmware(elf_firmware_t& firmware) {
  for (avr_symbol_t* symbol : std::span(firmware.symbol, firmware.symbolcount)) {
    std::free(symbol);
  }
  std::free(static_cast<void*>(firmware.symbol));
  std::free(firmware.flash);
  std::free(firmware.eeprom);
}

}  // namespace

void load_elf_program(const std::filesystem::path& elf, avr_t& avr) {
  check_is_avr_elf(elf);
  elf_firmware_t firmware{};
  if (elf_read_firmware(elf.c_str(), &firmware) != 0) {
    fail(elf, "cannot be read as an ELF file");
  }
  const bool fits = firmware.flashsize > 0 && firmware.flashsize <= avr.flashend + 1;
  if (fits) {
    avr_loadcode(&avr, firmware.flash, firmware.flashsize, firmware.flashbase);
    avr.codeend = firmware.flashbase + firmware.flashsize - firmware.datasize;
  }
  free_firmware(firmware);
  if (!fits) {
    fail(elf, "holds no program that fits into the flash");
  }
}

}  // namespace echomap::emulator
