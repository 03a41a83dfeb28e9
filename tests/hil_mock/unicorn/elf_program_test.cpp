// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/elf_program.hpp"

#include <cstdint>
#include <elf.h>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::unicorn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

template <class T>
std::string bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

/// A file with one segment of four bytes, loaded at 0x20000000 from 0x08000100.
struct SmallElf {
  SmallElf() {
    header.e_ident[EI_MAG0] = ELFMAG0;
    header.e_ident[EI_MAG1] = ELFMAG1;
    header.e_ident[EI_MAG2] = ELFMAG2;
    header.e_ident[EI_MAG3] = ELFMAG3;
    header.e_ident[EI_CLASS] = ELFCLASS32;
    header.e_machine = EM_ARM;
    header.e_phoff = sizeof(header);
    header.e_phnum = 1;
    segment.p_type = PT_LOAD;
    segment.p_offset = sizeof(header) + sizeof(segment);
    segment.p_paddr = 0x08000100;
    segment.p_vaddr = 0x20000000;
    segment.p_filesz = 4;
  }

  std::string text() const { return bytes_of(header) + bytes_of(segment) + "\1\2\3\4"; }

  Elf32_Ehdr header{};
  Elf32_Phdr segment{};
};

class ElfProgram : public ::testing::Test {
 protected:
  std::vector<ProgramSegment> read(const std::string& text) {
    files::write_text_file(folder / "program.elf", text);
    return read_elf_program(folder / "program.elf");
  }

  auto refusal(const std::string& text, const std::string& why) {
    return std::pair([this, text] { read(text); },
                     ThrowsMessage<std::runtime_error>(HasSubstr("program.elf: " + why)));
  }

  tests::ScratchFolder folder;
};

TEST_F(ElfProgram, ReadsWhatIsLoadedByItsPhysicalAddress) {
  const auto segments = read(SmallElf().text());
  ASSERT_EQ(segments.size(), 1U);
  EXPECT_EQ(segments[0].address, 0x08000100U);
  EXPECT_THAT(segments[0].bytes, ElementsAre(1, 2, 3, 4));
}

TEST_F(ElfProgram, RefusesAFileThatEndsBeforeItsSegment) {
  SmallElf elf;
  const std::string whole = elf.text();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW(read(whole.substr(0, size)), std::runtime_error) << size;
  }
  elf.segment.p_offset = UINT32_MAX;
  const auto [reading, says] = refusal(elf.text(), "is cut short");
  EXPECT_THAT(reading, says);
}

TEST_F(ElfProgram, RefusesAProgramForAnotherProcessor) {
  SmallElf elf;
  elf.header.e_machine = EM_AVR;
  const auto [reading, says] = refusal(elf.text(), "is no ELF file of an ARM program");
  EXPECT_THAT(reading, says);
}

TEST_F(ElfProgram, RefusesAFileThatLoadsNothing) {
  SmallElf elf;
  elf.segment.p_type = PT_NOTE;
  const auto [reading, says] = refusal(elf.text(), "holds no program");
  EXPECT_THAT(reading, says);
}

TEST_F(ElfProgram, SaysWhichFileIsNotThere) {
  EXPECT_THAT([&] { read_elf_program(folder / "none.elf"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("none.elf: cannot be opened")));
}

}  // namespace
}  // namespace echomap::unicorn
