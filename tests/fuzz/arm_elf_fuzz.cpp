// SPDX-License-Identifier: MIT
#include <cstdint>
#include <stdexcept>

#include "hil_mock/unicorn/elf_program.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/support/small_elf.hpp"

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  return {input_of(tests::SmallArmElf().text())};
}

/// One input is the file behind --firmware of echomap-unicorn. It is read, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace echomap;
  static fuzz::MemoryFile file;
  file.write({data, size});
  try {
    std::size_t bytes = 0;
    for (const auto& segment : unicorn::read_elf_program(file.path())) {
      fuzz::require(!segment.bytes.empty(), "a segment has bytes");
      fuzz::require(segment.bytes.size() <= size, "a segment has no more bytes than the file");
      bytes += segment.bytes.size();
    }
    fuzz::require(bytes != 0, "a program has bytes");
  } catch (const std::runtime_error&) {
  }
  return 0;
}
