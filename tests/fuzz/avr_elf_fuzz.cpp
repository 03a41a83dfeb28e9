// SPDX-License-Identifier: MIT
#include <cstdint>
#include <stdexcept>
#include <string>

#include "hil_mock/emulator/elf_program.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/support/small_elf.hpp"

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  tests::SmallAvrElf bare("atmega2560");
  bare.note.sh_type = SHT_NOBITS;
  return {input_of(tests::SmallAvrElf("atmega328p").text()), input_of(bare.text())};
}

/// One input is the file behind --firmware of echomap-simavr. It names a chip, or is refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace echomap;
  static fuzz::MemoryFile file;
  file.write({data, size});
  try {
    const std::string chip = emulator::chip_of_elf(file.path());
    fuzz::require(!chip.empty() && chip.size() <= size, "the chip's name stands in the file");
    fuzz::require(chip.find('\0') == std::string::npos, "a name ends at its zero");
  } catch (const std::runtime_error&) {
  }
  return 0;
}
