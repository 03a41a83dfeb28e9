// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/elf_program.hpp"

#include <cstdint>
#include <elf.h>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/small_elf.hpp"

namespace echomap::unicorn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

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
  const auto segments = read(tests::SmallArmElf().text());
  ASSERT_EQ(segments.size(), 1U);
  EXPECT_EQ(segments[0].address, 0x08000100U);
  EXPECT_THAT(segments[0].bytes, ElementsAre(1, 2, 3, 4));
}

TEST_F(ElfProgram, RefusesAFileThatEndsBeforeItsSegment) {
  tests::SmallArmElf elf;
  const std::string whole = elf.text();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW(read(whole.substr(0, size)), std::runtime_error) << size;
  }
  elf.segment.p_offset = UINT32_MAX;
  const auto [reading, says] = refusal(elf.text(), "is cut short");
  EXPECT_THAT(reading, says);
}

TEST_F(ElfProgram, RefusesAProgramForAnotherProcessor) {
  tests::SmallArmElf elf;
  elf.header.e_machine = EM_AVR;
  const auto [reading, says] = refusal(elf.text(), "is no ELF file of an ARM program");
  EXPECT_THAT(reading, says);
}

TEST_F(ElfProgram, RefusesAFileThatLoadsNothing) {
  tests::SmallArmElf elf;
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
