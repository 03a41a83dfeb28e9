// SPDX-License-Identifier: MIT
#include "host/flashing/rp2040_image.hpp"

#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "tests/host/flashing/pico_image.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::flashing {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Bytes bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

std::string refusal_of(const std::filesystem::path& file) {
  try {
    read_rp2040_image(file);
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kRuntimeError);
    return error.what();
  }
  return "no error";
}

TEST(Rp2040Image, HasTheChecksumOfCrc32Mpeg2) {
  // The check value of CRC-32/MPEG-2, which has these parameters.
  EXPECT_EQ(boot_checksum(bytes_of("123456789")), 0x0376e6e7U);
}

TEST(Rp2040Image, IsTakenWithItsChecksumAndVectors) {
  EXPECT_EQ(fault_of_rp2040_image(pico_image(2480)), "");
  EXPECT_EQ(fault_of_rp2040_image(pico_image(kPicoFlashBytes)), "");
}

TEST(Rp2040Image, IsRefusedWithAnyBitOfItsBootStageChanged) {
  const Bytes good = pico_image(2480);
  for (std::size_t bit = 0; bit < 256 * 8; ++bit) {
    Bytes image = good;
    image[bit / 8] = static_cast<std::uint8_t>(image[bit / 8] ^ (1U << (bit % 8)));
    EXPECT_THAT(fault_of_rp2040_image(image), HasSubstr("not for an RP2040")) << bit;
  }
}

TEST(Rp2040Image, IsRefusedWithoutAProgramBehindTheBootStage) {
  for (const std::uint32_t stack : {0U, 0x10000000U, 0x20042004U, 0x20040002U}) {
    Bytes image = pico_image(2480);
    put_little_endian(image, 256, stack);
    EXPECT_THAT(fault_of_rp2040_image(image), HasSubstr("no program")) << stack;
  }
  for (const std::uint32_t start : {0U, kFlashBegin + 0x1c0, kFlashBegin + 1, kFlashBegin + 2481}) {
    Bytes image = pico_image(2480);
    put_little_endian(image, 260, start);
    EXPECT_THAT(fault_of_rp2040_image(image), HasSubstr("no program")) << start;
  }
}

TEST(Rp2040Image, IsRefusedWhereItIsTooShortOrTooLong) {
  EXPECT_THAT(fault_of_rp2040_image({}), HasSubstr("0 bytes, too few"));
  EXPECT_THAT(fault_of_rp2040_image(pico_image(264)), HasSubstr("no program"));
  EXPECT_THAT(fault_of_rp2040_image(pico_image(kPicoFlashBytes + 1)),
              HasSubstr("more than the 2097152 of a Pico's flash"));
}

TEST(Rp2040Image, IsReadFromBothKindsOfFiles) {
  const tests::ScratchFolder folder;
  write_bytes(folder / "x.bin", pico_image(4096));
  write_bytes(folder / "x.uf2", uf2_of(pico_image(4096)));
  EXPECT_EQ(read_rp2040_image(folder / "x.bin"), pico_image(4096));
  EXPECT_EQ(read_rp2040_image(folder / "x.uf2"), pico_image(4096));
}

TEST(Rp2040Image, IsRefusedWithTheNameOfItsFileAndTheNextStep) {
  const tests::ScratchFolder folder;
  write_bytes(folder / "x.elf",
              bytes_of("\x7f"
                       "ELF and more"));
  EXPECT_THAT(refusal_of(folder / "x.elf"),
              AllOf(HasSubstr("will not flash " + (folder / "x.elf").string()),
                    HasSubstr("it is an ELF file; take the .bin or .uf2"),
                    HasSubstr("next: ./run build firmware_pico")));
  write_bytes(folder / "x.hex", bytes_of(":100000000C9434000C943E00" + std::string(300, '0')));
  EXPECT_THAT(refusal_of(folder / "x.hex"), HasSubstr("it is not for an RP2040"));
  Bytes cut = uf2_of(pico_image(300));
  cut.resize(700);
  write_bytes(folder / "x.uf2", cut);
  EXPECT_THAT(refusal_of(folder / "x.uf2"), HasSubstr("no whole blocks"));
}

}  // namespace
}  // namespace echomap::flashing
